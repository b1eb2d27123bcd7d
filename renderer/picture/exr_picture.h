#pragma once

#include "renderer/film/exr_options.h"
#include "renderer/geometry/camera.h"
#include "renderer/prepared/render_scene.h"

namespace asos {

/// Returns the contents of an EXR of the scene: the layers of the settings, the names of objects
/// and materials, and the camera's matrices, from the scene's own coordinates, for the visible part
/// of the picture.
[[nodiscard]] ExrOptions exr_options(const RenderScene& scene, const Camera& camera,
                                     const RenderSettings& settings);

}  // namespace asos
