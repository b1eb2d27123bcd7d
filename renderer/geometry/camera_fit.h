#pragma once

#include "renderer/geometry/camera.h"

namespace asos {

/// How a camera with an aspect ratio is fitted to a picture with another one (glTF 2.0, section
/// 3.10.3).
enum class CameraFit {
  crop,  ///< by height: a wider camera loses its sides
  fit,   ///< the whole frame of the camera, with margins above and below or at the sides
  fill,  ///< the frame covers the picture: it loses its sides, or its top and bottom
};

/// Returns the camera for a picture of `aspect_ratio` (width over height): only the vertical angle,
/// or the height, changes. It stays the same if the camera has no aspect ratio, if the ratios
/// differ by less than half a pixel in a thousand, or if no camera is that wide (validate_camera).
[[nodiscard]] Camera fitted_camera(const Camera& camera, double aspect_ratio, CameraFit fit);

}  // namespace asos
