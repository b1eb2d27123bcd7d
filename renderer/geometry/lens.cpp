#include "renderer/geometry/lens.h"

#include "renderer/geometry/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;

/// A point of the unit disk: its radius and its angle, 0 to 2 pi.
struct Polar {
  double r, angle;
};

Polar concentric(glm::dvec2 uv) {
  const double a = 2.0 * uv.x - 1.0, b = 2.0 * uv.y - 1.0;
  if (a == 0.0 && b == 0.0) return {0.0, 0.0};
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  double angle = wide ? 0.25 * pi * (b / a) : 0.5 * pi - 0.25 * pi * (a / b);
  if (r < 0.0) angle += pi;
  return {std::abs(r), angle < 0.0 ? angle + 2.0 * pi : angle};
}

glm::dvec2 on_circle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

std::string validate_lens(const Lens& lens) {
  if (!(lens.radius >= 0.0 && lens.radius <= largest_coordinate))
    return fmt::format("\"radius\" is not from 0 to {:g}", largest_coordinate);
  if (lens.focus && !(*lens.focus > 0.0 && *lens.focus <= largest_coordinate))
    return fmt::format("\"focus\" is not above 0 and up to {:g}", largest_coordinate);
  if (lens.blades != 0 && (lens.blades < Lens::fewest_blades || lens.blades > Lens::most_blades))
    return fmt::format("\"blades\" is neither 0 nor from {} to {}", Lens::fewest_blades,
                       Lens::most_blades);
  if (!(std::abs(lens.turn_rad) <= 2.0 * pi)) return "\"turn_rad\" is not from -2 pi to 2 pi";
  return "";
}

glm::dvec2 point_on_aperture(const Lens& lens, glm::dvec2 uv) {
  const Polar disk = concentric(uv);
  if (lens.blades == 0) return lens.radius * disk.r * on_circle(disk.angle + lens.turn_rad);
  // Equal angles of the disk become equal lengths along the polygon's sides.
  const double side = disk.angle * lens.blades / (2.0 * pi);
  const double first = std::min(std::floor(side), lens.blades - 1.0);
  const double step = 2.0 * pi / lens.blades;
  const glm::dvec2 from = on_circle(first * step + lens.turn_rad);
  const glm::dvec2 to = on_circle((first + 1.0) * step + lens.turn_rad);
  return lens.radius * disk.r * glm::mix(from, to, side - first);
}

double aperture_share(const Lens& lens) {
  if (lens.blades == 0) return 1.0;
  return 0.5 * lens.blades * std::sin(2.0 * pi / lens.blades) / pi;
}

double aperture_variance(const Lens& lens) {
  if (lens.blades == 0) return 0.25;
  return (2.0 + std::cos(2.0 * pi / lens.blades)) / 12.0;
}

double aperture_of_f_stop(double f_stop, double fov_y_rad) {
  return 0.25 * Lens::sensor_height / (std::tan(0.5 * fov_y_rad) * f_stop);
}

double f_stop_of_aperture(double radius, double fov_y_rad) {
  return aperture_of_f_stop(radius, fov_y_rad);
}

}  // namespace asos
