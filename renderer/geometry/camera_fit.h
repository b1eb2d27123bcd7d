#pragma once

#include "renderer/geometry/camera.h"

namespace asos {

/// How a camera that asks for an aspect ratio is shown in a picture of another one (glTF 2.0,
/// section 3.10.3).
enum class CameraFit {
  crop,  ///< by height: a wider camera loses its sides
  fit,   ///< the whole frame of the camera, with margins above and below or at the sides
  fill,  ///< the frame covers the picture: it loses its sides, or its top and bottom
};

/// The camera for a picture of `aspect_ratio` (width over height): only the vertical angle, or the
/// height, differs. The same where it asks for no aspect ratio, where the ratios differ by less
/// than half a pixel in a thousand, or where no camera is that wide (camera_fault).
[[nodiscard]] Camera fitted_camera(const Camera& camera, double aspect_ratio, CameraFit fit);

}  // namespace asos
