#include "renderer/lights/rig_axes.h"
#include "renderer/lights/studio_rig.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asos {
namespace {

// Of the free way to a wall: what a light's middle, and its sides, keep to.
constexpr double way_to_ceiling = 0.9;
constexpr double way_to_wall = 0.8;
constexpr double half_width_to_distance = 0.25;
constexpr double bright_quantile = 0.9;
constexpr std::size_t candidates = 9;

/// The part of an eye ray, before the point that it sees, that no surface cuts: walls seen from
/// behind, which the eye does not see, end it too.
struct Stretch {
  glm::dvec3 end;        ///< just before the point
  glm::dvec3 to_viewer;  ///< unit
  double length = 0.0;

  Stretch(const SeenPoint& point, const FreeDistance& free_distance) {
    const glm::dvec3 back = point.eye - point.position;
    const double distance = glm::length(back);
    to_viewer = distance > 0.0 ? back / distance : point.normal;
    end = point.position + 1e-4 * distance * point.normal;
    length = std::min(distance, free_distance(end, to_viewer));
  }
  [[nodiscard]] glm::dvec3 at(double share) const { return end + share * length * to_viewer; }
};

/// A rectangle as large as asked, or as walls leave.
Light fitted(const char* name, glm::dvec3 middle, glm::dvec3 direction, glm::dvec3 right,
             double half_width, const FreeDistance& free_distance) {
  Light light = rig_rectangle(name, middle, direction, right, 1.0, 1.0);
  const auto fit = [&](glm::dvec3& half) {
    const double room = std::min(free_distance(middle, half), free_distance(middle, -half));
    half *= std::max(std::min(half_width, way_to_wall * room), 1e-3 * half_width);
  };
  fit(light.half_u);
  fit(light.half_v);
  return light;
}

Light ceiling_light(const Stretch& stretch, const glm::dmat3& axes,
                    const FreeDistance& free_distance) {
  const glm::dvec3 down = -axes[1];
  const glm::dvec3 below = stretch.at(0.5);
  const double height = std::min(stretch.length, free_distance(below, axes[1]));
  const glm::dvec3 middle = below + way_to_ceiling * height * axes[1];
  const double distance = std::min(free_distance(middle, down), height + stretch.length);
  return fitted("key", middle, down, axes[0], half_width_to_distance * distance, free_distance);
}

Light viewer_light(const Stretch& stretch, const glm::dmat3& axes,
                   const FreeDistance& free_distance) {
  const glm::dvec3 level = stretch.at(way_to_ceiling);
  const double room =
      std::min(half_width_to_distance * stretch.length, 0.5 * free_distance(level, axes[0]));
  const glm::dvec3 middle = level + room * axes[0];
  // A view straight up or down leaves no right of its own.
  const bool steep = std::abs(stretch.to_viewer.y) > 0.99;
  return fitted("fill", middle, -stretch.to_viewer, steep ? axes[2] : axes[0],
                half_width_to_distance * stretch.length, free_distance);
}

/// Gives the brighter ones of the seen points `radiance`; those on the stretch if it shines on
/// none.
void set_intensity(Light& light, double radiance, std::span<const SeenPoint> seen,
                   const Stretch& stretch) {
  std::vector<double> irradiance;
  for (const SeenPoint& point : seen)
    irradiance.push_back(irradiance_of_unit(light, point.position, point.normal));
  std::sort(irradiance.begin(), irradiance.end());
  const auto bright =
      static_cast<std::size_t>(bright_quantile * static_cast<double>(irradiance.size() - 1));
  double reference = irradiance[bright] > 0.0 ? irradiance[bright] : irradiance.back();
  if (!(reference > 0.0)) reference = irradiance_of_unit(light, stretch.end, -light.direction);
  const double nits = std::numbers::pi * radiance / reference;
  light.intensity = std::isfinite(static_cast<float>(nits)) ? static_cast<float>(nits) : 0.0f;
}

}  // namespace

std::vector<Light> interior_rig(const Camera& camera, std::span<const SeenPoint> seen,
                                const FreeDistance& free_distance) {
  const glm::dmat3 axes = rig_axes(camera);
  double best_share = -1.0;
  std::vector<Light> best;
  for (std::size_t i = 0; i < candidates; ++i) {
    const SeenPoint& point = seen[(2 * i + 1) * seen.size() / (2 * candidates)];
    const Stretch stretch(point, free_distance);
    Light key = ceiling_light(stretch, axes, free_distance);
    const double share = reached_share({&key, 1}, seen, free_distance);
    if (share <= best_share) continue;
    best_share = share;
    Light fill = viewer_light(stretch, axes, free_distance);
    set_intensity(key, key_radiance, seen, stretch);
    set_intensity(fill, fill_radiance, seen, stretch);
    best = {std::move(key), std::move(fill)};
  }
  return best;
}

}  // namespace asos
