#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/kernels/weigh_lights.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Selects the lights to which a batch of points sends shadow rays. Each light is weighed by its
/// estimated contribution at the point (weigh_lights). Each of a point's rays represents an equal
/// part of the total (Shirley, Wang and Zimmerman 1996, section 4), except for the strongest
/// lights, which get one ray each. Selection is by systematic sampling with one random number per
/// point. A light's probability is proportional to its weight, and its ray is divided by the
/// probability, so that the mean is that of all lights.
class LightSelection {
 public:
  /// With at most this many lights, each of them gets a ray.
  static constexpr std::size_t few_lights = 6;
  /// Largest average number of shadow rays per point if there are more lights.
  static constexpr float rays_a_point = 4.0f;

  /// Picks lights for all points. `at` is each point's random number, a 32-bit fraction.
  void pick(const LightTable& lights, const ShadingPoints& points,
            const LightPointBatch::Fractions& at, float a_point = rays_a_point);

  /// The points that picked a light of the table, ascending, with 1 / probability of each. Valid
  /// until the next call of `pick`.
  struct Points {
    std::span<const std::uint32_t> point;
    std::span<const float> weight;
  };
  [[nodiscard]] Points of(std::size_t light) const {
    const std::size_t first = first_[light], count = first_[light + 1] - first;
    return {std::span(point_).subspan(first, count), std::span(weight_).subspan(first, count)};
  }

 private:
  struct Pick {
    std::uint32_t light, point;
    float weight;
  };
  [[nodiscard]] float share_of_ray(float all, float a_point) const;
  void pick_for(std::uint32_t point, float share, float walked);
  void sort_by_light(std::size_t lights);

  std::vector<float> worth_;  // of each light, at one point
  std::vector<Pick> picks_;   // point by point
  // Picks sorted by light: the first index of each light, and the picks.
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> point_;
  std::vector<float> weight_;
};

}  // namespace asos
