#pragma once

#include "renderer/geometry/camera.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/settings/settings.h"

namespace asos {

/// Returns the camera with its lens focused. Automatic focus is the depth of the surface at the
/// picture's centre, or nearest to it; without any visible surface, that of the scene's centre.
[[nodiscard]] Camera focused(const RenderScene& scene, const Camera& camera,
                             const RenderSettings& settings);

}  // namespace asos
