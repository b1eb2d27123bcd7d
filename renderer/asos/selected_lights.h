#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/unshadowed_contributions.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sobol_sampler.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Lights of a scene that are too dim in a block to be sampled one by one. A leaf's contribution
/// from all of these is the mean over points that are well distributed over the leaf. Each point
/// sends a few shadow rays to lights that are selected by their unshadowed contribution
/// (LightSelection). Points of all leaves of a block are shaded in batches; in mirrors, those of
/// each leaf immediately.
class SelectedLights {
 public:
  /// Both arguments have to outlive this object.
  SelectedLights(const EyeContext& eye, EyeSamples& samples);
  SelectedLights(const SelectedLights&) = delete;
  SelectedLights& operator=(const SelectedLights&) = delete;

  /// Chooses the sampled lights from their contributions at the centres of side x side roots (the
  /// first samples). The choice has the least total cost: one ray series for each other light, plus
  /// the rays to selected ones.
  void find(int side);
  /// Samples all lights that cast shadows. One reflected ray is worth no more, and choosing the
  /// lights would cost more than the ray.
  void take_all();

  /// Returns for each light whether it is sampled. Empty: none is.
  [[nodiscard]] std::span<const std::uint8_t> lights() const { return sampled_; }
  [[nodiscard]] bool holds(std::size_t light) const {
    return !sampled_.empty() && sampled_[light] != 0;
  }

  /// Begins the sampled lights' contribution to a leaf and returns its number.
  std::uint32_t start(const Leaf& leaf);
  /// Queues points on a surface of the leaf, to be shaded by `run`.
  void add(std::uint32_t number, const LightingQuery& point, const Leaf& leaf);
  /// Returns the sampled lights' contribution to a surface of a leaf, immediately.
  [[nodiscard]] glm::vec3 at_once(const LightingQuery& point, const Leaf& leaf);
  /// Drops a contribution.
  void drop(std::uint32_t number) { queue_.drop(number); }

  /// Shades all deferred points and empties the queue. The result is valid until the next leaf.
  std::span<const Contribution> run();

 private:
  /// The expected contribution of the sampled lights.
  struct Expected {
    double intensity = 0.0;      ///< of all sampled lights together, where they are brightest
    double rays_of_point = 1.0;  ///< average rays per point, where they are brightest
  };
  [[nodiscard]] bool sought() const;
  [[nodiscard]] Expected expected(std::span<const double> carried) const;
  [[nodiscard]] Expected expected_at(const LightingQuery& point);
  [[nodiscard]] std::uint32_t points_of(double weight, const Expected& expected) const;
  void look(const LightingQuery& point, const Leaf& leaf, std::uint32_t count);

  const EyeContext* eye_;
  EyeSamples* samples_;
  std::vector<std::uint8_t> sampled_;
  std::optional<UnshadowedContributions> carried_;
  Expected expected_;  // from each light's brightest pixel centre
  SobolSampler places_;
  SampledLights lights_;
  BlockQueue queue_;
  std::vector<glm::dvec3> sums_;  // sums of the deferred leaves
  // Scratch: places in the frame with their numbers, and the surface there.
  std::vector<glm::vec2> at_;
  std::vector<std::uint32_t> number_;
  std::vector<SurfacePoint> seen_;
};

}  // namespace asos
