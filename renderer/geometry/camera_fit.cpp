#include "renderer/geometry/camera_fit.h"

#include "renderer/geometry/validate_camera.h"

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

// Tolerance of aspect ratios, since pictures have whole pixels, and files have ratios such as
// 1.7778: half a pixel in a thousand.
constexpr double same_ratio = 5e-4;

}  // namespace

Camera fitted_camera(const Camera& camera, double aspect_ratio, CameraFit fit) {
  if (!camera.aspect_ratio || fit == CameraFit::crop) return camera;
  const double wider = *camera.aspect_ratio / aspect_ratio;
  const double factor = fit == CameraFit::fit ? std::max(1.0, wider) : std::min(1.0, wider);
  if (std::abs(factor - 1.0) < same_ratio || !std::isfinite(factor) || !(factor > 0.0))
    return camera;
  Camera fitted = camera;
  if (camera.type == Camera::Type::perspective)
    fitted.fov_y_rad = 2.0 * std::atan(factor * std::tan(0.5 * camera.fov_y_rad));
  else
    fitted.height = factor * camera.height;
  return validate_camera(fitted).empty() ? fitted : camera;
}

}  // namespace asos
