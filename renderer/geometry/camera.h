#pragma once

#include "renderer/geometry/lens.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace asos {

/// A camera in the world. It looks along -Z of `world_from_camera`, with +Y up; the columns of the
/// upper 3x3 are orthonormal.
struct Camera {
  enum class Type { perspective, orthographic };

  std::string name;
  Type type = Type::perspective;
  glm::dmat4 world_from_camera{1.0};
  double fov_y_rad = 0.8726646259971648;  ///< perspective: full vertical angle, in (0, pi)
  double height = 1.0;                    ///< orthographic: full height in world units
  std::optional<double> aspect_ratio;     ///< width over height, if the file has one
  /// The picture shows nothing nearer or farther than these depths along the view's axis (glTF's
  /// znear and zfar). Shadows and reflections still include such objects.
  std::optional<double> near_depth, far_depth;
  Lens lens;  ///< perspective: depth of field

  /// Returns the camera without near and far plane.
  [[nodiscard]] Camera without_planes() const {
    Camera camera = *this;
    camera.near_depth = camera.far_depth = std::nullopt;
    return camera;
  }
  bool operator==(const Camera&) const = default;
};

}  // namespace asos
