#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// The geometry of `scene` with other surfaces: built anew, with all that is told of it. Errors
/// name the scene's file.
[[nodiscard]] Result<std::shared_ptr<Geometry>> rebuilt_geometry(const RenderScene& scene,
                                                                 World world);

}  // namespace asos
