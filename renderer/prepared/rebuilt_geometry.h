#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>

namespace asos {

/// Returns the geometry of `scene` with other surfaces: newly built, with the same description.
/// Errors have the scene's file name.
[[nodiscard]] Result<std::shared_ptr<Geometry>> rebuilt_geometry(const RenderScene& scene,
                                                                 World world);

}  // namespace asos
