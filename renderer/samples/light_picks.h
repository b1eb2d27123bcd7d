#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/kernels/weigh_lights.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Which of many lights a batch of points sends its shadow rays to: each is weighed by what it is
/// about worth at the point (weigh_lights); of a point's rays, each stands for as much of that as
/// the next (Shirley, Wang and Zimmerman 1996, section 4), but for the lights that are worth more.
/// They are chosen by systematic sampling: each light is chosen with the probability that its share
/// deserves, by one number a point, and what its ray carries is divided by it, so that the mean is
/// that of all lights.
class LightPicks {
 public:
  /// In scenes with so many lights, each of them gets its ray.
  static constexpr std::size_t few_lights = 6;
  /// A point's shadow rays where there are more: so many on the average at most.
  static constexpr float rays_a_point = 4.0f;

  /// Picks for all points. `at`: each one's number, of 2^32.
  void pick(const LightTable& lights, const LitBatch& points, const LightPlaceBatch::Fractions& at,
            float a_point = rays_a_point);

  /// The points that picked a light of the table, ascending, and 1 / probability of each. Valid
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

  std::vector<float> worth_;  // each light, at a point
  std::vector<Pick> picks_;   // point by point
  // Light by light: where each one's begin, and what they are.
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> point_;
  std::vector<float> weight_;
};

}  // namespace asos
