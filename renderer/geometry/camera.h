#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace asos {

/// A camera placed in the world; it looks along -Z of `world_from_camera`, +Y is up, the columns of
/// its upper 3x3 are orthonormal.
struct Camera {
  enum class Type { perspective, orthographic };

  std::string name;
  Type type = Type::perspective;
  glm::dmat4 world_from_camera{1.0};
  double fov_y_rad = 0.8726646259971648;  ///< perspective: full vertical angle, in (0, pi)
  double height = 1.0;                    ///< orthographic: full height in world units
  std::optional<double> aspect_ratio;     ///< width over height, where the file asks for one
  /// Depths that the file asks to cut the picture off at (glTF's znear and zfar). Nothing is.
  std::optional<double> near_depth, far_depth;
};

}  // namespace asos
