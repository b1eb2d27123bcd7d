#pragma once

#include "renderer/kernels/light_kernel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Which of many lights a batch of points sends its shadow rays to: of a point's rays, each carries
/// as much of the point's light as the next (Shirley, Wang and Zimmerman 1996, section 4), but for
/// the lights that are brighter than that. They are chosen by systematic sampling: each light is
/// chosen with the probability that its share deserves, by one number a point, and what a ray
/// carries is divided by it, so that the mean is that of all lights.
class LightPicks {
 public:
  /// In scenes with so many lights, each of them gets its ray.
  static constexpr std::size_t few_lights = 6;
  /// A point's shadow rays where there are more: so many on the average at most.
  static constexpr float rays_a_point = 4.0f;

  /// The rays of so many lights are held at once (13 kB each); those of more are made twice: to be
  /// weighed, and to be kept.
  static constexpr std::size_t most_held = 1024;

  /// Room for the rays that `lights` lights would get, none as yet. Their memory is kept.
  void start(std::size_t lights);
  /// The rays of a light, to be filled in.
  [[nodiscard]] ShadowRayBatch& rays(std::size_t light) { return rays_[light]; }
  /// Keeps those that are picked. `points`: how many there are; `at`: each one's number, of 2^32.
  void pick(std::size_t points, const LightPlaceBatch::Fractions& at, float a_point = rays_a_point);

  /// Some of the lights.
  struct Range {
    std::size_t first = 0, count = 0;
  };
  /// Of the rays of some, each point keeps one, the likelier the more it carries, and that carries
  /// `share` of all of theirs together: those of all points go to `kept`.
  void pick_one(std::size_t points, Range lights, const LightPlaceBatch::Fractions& at, float share,
                ShadowRayBatch& kept);

  /// The steps of `pick`: first each light's rays are weighed, in turn; then, from `walk` on, each
  /// light's are kept or not, in the same turn.
  void weigh_none(std::size_t points) { share_.assign(points, 0.0f); }
  void weigh(const ShadowRayBatch& rays);
  void walk(const LightPlaceBatch::Fractions& at, float a_point);
  void keep_picked(ShadowRayBatch& rays);

 private:
  std::vector<ShadowRayBatch> rays_;
  std::size_t lights_ = 0;
  std::vector<float> share_;   // of a point's light that a ray should carry
  std::vector<float> walked_;  // a point's shares since its last ray
};

}  // namespace asos
