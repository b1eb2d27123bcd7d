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

  /// Picks lights for all points. `at` is each point's random number, a 32-bit fraction. The bits
  /// of a point's picks depend only on the point, its number and the lights, not on its place in
  /// the batch or the instruction set.
  void pick(std::span<const LightBounds> lights, const ShadingPoints& points,
            const LightPointBatch::Fractions& at, float a_point = rays_a_point);

  /// The points that picked a light, ascending, with 1 / probability of each. Valid
  /// until the next call of `pick`.
  struct Points {
    std::span<const std::uint32_t> point;
    std::span<const float> weight;
  };
  [[nodiscard]] Points of(std::size_t light) const {
    const std::size_t first = first_[light], count = first_[light + 1] - first;
    return {std::span(point_).subspan(first, count), std::span(weight_).subspan(first, count)};
  }

  /// For the kernel: arrays to which a light's points are appended.
  struct Room {
    std::uint32_t* point;
    float* weight;
  };
  [[nodiscard]] Room next_light() {
    // A kernel may write a whole vector beyond the end.
    const std::size_t first = first_.back(), room = first + ShadingPoints::size + 16;
    if (point_.size() < room) point_.resize(2 * room), weight_.resize(2 * room);
    return {&point_[first], &weight_[first]};
  }
  void picked(std::size_t points) { first_.push_back(first_.back() + points); }

 private:
  std::vector<ShadingPoints::Floats> weights_;  // by light, at all points
  // Picks light by light: the first index of each light, and the picks.
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> point_;
  std::vector<float> weight_;
};

}  // namespace asos
