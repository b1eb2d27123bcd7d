#include "renderer/lights/studio_lighting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asos {
namespace {

// Fractions of the free distance to a ceiling or wall for a light's centre, and for its sides.
constexpr double way_to_ceiling = 0.9;
constexpr double way_to_wall = 0.8;
constexpr double half_width_to_distance = 0.25;
constexpr double bright_quantile = 0.9;
constexpr std::size_t candidates = 9;

/// A part of an eye ray, in front of the visible point, that no surface cuts. Back faces of walls,
/// which are invisible to the eye, end it, too.
struct Stretch {
  glm::dvec3 end;        ///< just in front of the point
  glm::dvec3 to_viewer;  ///< unit
  double length = 0.0;
  bool to_eye = true;  ///< it begins at the eye

  Stretch(const SeenPoint& point, const FreeDistance& free_distance) {
    const glm::dvec3 back = point.eye - point.position;
    const double distance = glm::length(back);
    to_viewer = distance > 0.0 ? back / distance : point.normal;
    end = point.position + 1e-4 * distance * point.normal;
    length = std::min(distance, free_distance(end, to_viewer));
    to_eye = length > 0.99 * distance;
  }
  [[nodiscard]] glm::dvec3 at(double share) const { return end + share * length * to_viewer; }
};

/// Returns a rectangle of the given size, or smaller if walls require it.
Light fitted(const char* name, glm::dvec3 middle, glm::dvec3 direction, glm::dvec3 right,
             double half_width, const FreeDistance& free_distance) {
  Light light = lighting_rectangle(name, middle, direction, right, 1.0, 1.0);
  const auto fit = [&](glm::dvec3& half) {
    const double room = std::min(free_distance(middle, half), free_distance(middle, -half));
    half *= std::max(std::min(half_width, way_to_wall * room), 1e-3 * half_width);
  };
  fit(light.half_u);
  fit(light.half_v);
  double scale = 1.0;
  for (const glm::dvec3& corner : {light.half_u + light.half_v, light.half_u - light.half_v,
                                   light.half_v - light.half_u, -light.half_u - light.half_v}) {
    const double length = glm::length(corner);
    scale = std::min(scale, way_to_wall * free_distance(middle, corner / length) / length);
  }
  light.half_u *= std::max(scale, 1e-3);
  light.half_v *= std::max(scale, 1e-3);
  return light;
}

/// Returns the distance of the assumed floor if nothing is below.
double farthest(const Stretch& stretch) {
  return 2.0 * stretch.length;
}

Light ceiling_light(const Stretch& stretch, const glm::dmat3& axes,
                    const FreeDistance& free_distance) {
  const glm::dvec3 down = -axes[1];
  const glm::dvec3 below = stretch.at(0.5);
  const double height = std::min(stretch.length, free_distance(below, axes[1]));
  const glm::dvec3 middle = below + way_to_ceiling * height * axes[1];
  const double distance = std::min(free_distance(middle, down), farthest(stretch));
  return fitted("Studio key", middle, down, axes[0], half_width_to_distance * distance,
                free_distance);
}

Light viewer_light(const Stretch& stretch, const glm::dmat3& axes,
                   const FreeDistance& free_distance) {
  const glm::dvec3 level = stretch.at(way_to_ceiling);
  const double room =
      std::min(half_width_to_distance * stretch.length, 0.5 * free_distance(level, axes[0]));
  const glm::dvec3 middle = level + room * axes[0];
  // A view straight up or down has no right of its own.
  const bool steep = std::abs(stretch.to_viewer.y) > 0.99;
  return fitted("Studio fill", middle, -stretch.to_viewer, steep ? axes[2] : axes[0],
                half_width_to_distance * stretch.length, free_distance);
}

/// Sets the intensity so that the surface ahead, and bright_quantile of the visible points that the
/// light reaches, get at most `radiance`.
void set_intensity(Light& light, double ahead, double radiance, std::span<const SeenPoint> seen,
                   const FreeDistance& free_distance) {
  std::vector<double> irradiance;
  for (const SeenPoint& point : seen) {
    if (reached(light, point, free_distance))
      irradiance.push_back(irradiance_of_unit(light, point.position, point.normal));
  }
  std::sort(irradiance.begin(), irradiance.end());
  double most =
      irradiance_of_unit(light, light.position + ahead * light.direction, -light.direction);
  if (!irradiance.empty()) {
    const double index = bright_quantile * static_cast<double>(irradiance.size() - 1);
    most = std::max(most, irradiance[static_cast<std::size_t>(index)]);
  }
  // A light without room for any size stays dark.
  const auto nits = static_cast<float>(std::numbers::pi * radiance / most);
  light.intensity = std::isfinite(nits) ? nits : 0.0f;
}

}  // namespace

std::vector<Light> interior_lighting(const Camera& camera, const Box& bounds,
                                     std::span<const SeenPoint> seen,
                                     const FreeDistance& free_distance) {
  const glm::dmat3 axes = lighting_axes(camera);
  double best_share = -1.0;
  std::vector<Light> best;
  for (std::size_t i = 0; i < candidates; ++i) {
    const SeenPoint& point = seen[(2 * i + 1) * seen.size() / (2 * candidates)];
    const Stretch stretch(point, free_distance);
    Light key = ceiling_light(stretch, axes, free_distance);
    const double share = reached_share({&key, 1}, seen, free_distance);
    if (share <= best_share) continue;
    best_share = share;
    const double to_floor = std::min(free_distance(key.position, key.direction), farthest(stretch));
    set_intensity(key, to_floor, key_radiance, seen, free_distance);
    Light fill;
    if (stretch.to_eye) {
      fill = viewer_light(stretch, axes, free_distance);
      set_intensity(fill, stretch.length, fill_radiance, seen, free_distance);
    } else {
      fill = studio_lighting(camera, bounds)[1];
      fill.casts_shadows = false;
    }
    best = {std::move(key), std::move(fill)};
  }
  return best;
}

}  // namespace asos
