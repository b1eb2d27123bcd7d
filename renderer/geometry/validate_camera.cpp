#include "renderer/geometry/validate_camera.h"

#include "renderer/geometry/coordinates.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace asos {

std::string validate_camera(const Camera& camera) {
  constexpr double slack = 1e-6;
  const glm::dmat3 turn(camera.world_from_camera);
  const glm::dmat3 product = glm::transpose(turn) * turn;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) <= slack))
        return "right, up and back are not orthonormal";
  if (!within_reach(glm::dvec3(camera.world_from_camera[3])))
    return fmt::format("\"eye\" is farther away than {:g}", largest_coordinate);
  if (!(camera.fov_y_rad > 0.0 && camera.fov_y_rad < std::numbers::pi))
    return "\"fov_y_rad\" is not between 0 and pi";
  if (!(camera.height > 0.0)) return "\"height\" is not above 0";
  if (!(camera.height <= largest_coordinate))
    return fmt::format("\"height\" is more than {:g}", largest_coordinate);
  if (camera.near_depth && !(*camera.near_depth >= 0.0)) return "\"near_depth\" is below 0";
  if (camera.far_depth && !(*camera.far_depth > camera.near_depth.value_or(0.0)))
    return "\"far_depth\" is not beyond \"near_depth\"";
  if (camera.lens.blurs() && camera.type != Camera::Type::perspective)
    return "\"lens\" belongs to perspective cameras";
  if (const std::string fault = validate_lens(camera.lens); !fault.empty()) return "lens: " + fault;
  return "";
}

}  // namespace asos
