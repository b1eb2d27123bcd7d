#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Lights of a scene that are too dim in a block to be sampled one by one. Samples of a leaf send a
/// few shadow rays to some of them, selected by their unshadowed contribution (LightSelection).
class SelectedLights {
 public:
  /// Both arguments have to outlive this object.
  SelectedLights(const EyeContext& eye, const EyeSamples& samples)
      : eye_(&eye), samples_(&samples) {}

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

 private:
  [[nodiscard]] bool sought() const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  std::vector<std::uint8_t> sampled_;
};

}  // namespace asos
