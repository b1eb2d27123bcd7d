#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/carried_light.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sobol_places.h"
#include "renderer/shadows/leaf_context.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// The lights of a scene with many of them that are too dim in a block to be asked one by one: what
/// leaves get of all of these together is the mean of points that are well distributed over each
/// leaf, whose few shadow rays go to lights that are picked by what they carry (LightPicks). Points
/// of all leaves of a block are shaded in batches; in mirrors, each leaf's at once.
class WeakLights {
 public:
  /// Both have to outlive this.
  WeakLights(const EyeContext& eye, EyeSamples& samples);
  WeakLights(const WeakLights&) = delete;
  WeakLights& operator=(const WeakLights&) = delete;

  /// Learns from the first samples, the middles of side x side roots, which lights are weak: so
  /// that asking the others one by one, and for the weak ones as many rays as they are worth
  /// together, costs least.
  void find(int side);
  /// Takes all that cast shadows for weak: one ray of a mirror is worth no more, nor is to judge
  /// them by it.
  void take_all();

  /// One a light: whether it is weak. Empty: none is.
  [[nodiscard]] std::span<const std::uint8_t> lights() const { return weak_; }
  [[nodiscard]] bool holds(std::size_t light) const { return !weak_.empty() && weak_[light] != 0; }

  /// Begins the contribution of these lights to a leaf; its number.
  std::uint32_t start(std::uint32_t root, SampleId sample, double weight);
  /// Adds a surface of the leaf to its contribution, to be shaded later.
  void add(std::uint32_t number, const LitPoint& point, const LeafContext& leaf);
  /// What a surface of a leaf gets of them, now.
  [[nodiscard]] glm::vec3 at_once(const LitPoint& point, const LeafContext& leaf);
  /// Leaves a contribution out.
  void drop(std::uint32_t number) { queue_.drop(number); }

  /// Shades all that was added. Valid until the next leaf; none waits then.
  std::span<const Contribution> run();

 private:
  /// What the weak lights are worth.
  struct Expected {
    double intensity = 0.0;      ///< of all together, where they are brightest
    double rays_of_point = 1.0;  ///< that they get, about, where they are brightest
  };
  [[nodiscard]] bool sought() const;
  [[nodiscard]] Expected expected(std::span<const double> carried) const;
  [[nodiscard]] Expected expected_at(const LitPoint& point);
  [[nodiscard]] std::uint32_t points_of(double weight, const Expected& expected) const;
  void look(const LitPoint& point, const LeafContext& leaf, std::uint32_t count);

  const EyeContext* eye_;
  EyeSamples* samples_;
  std::vector<std::uint8_t> weak_;
  std::optional<CarriedLight> carried_;
  Expected expected_;  // where the pixels' middles see most of them
  SobolPlaces places_;
  SampledLights lights_;
  BlockQueue queue_;
  std::vector<glm::dvec3> sums_;  // of each that waits
  // Scratch: places in the frame with their numbers, and the surface there.
  std::vector<glm::vec2> at_;
  std::vector<std::uint32_t> number_;
  std::vector<SurfacePoint> seen_;
};

}  // namespace asos
