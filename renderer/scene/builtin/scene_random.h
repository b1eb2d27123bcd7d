#pragma once

#include "renderer/sampling/random.h"

#include <cstdint>

namespace asos::builtin {

/// Pseudo-random numbers, the same in every run.
class SceneRandom {
 public:
  explicit SceneRandom(std::uint64_t seed) : bits_(mix_bits(seed)) {}

  /// From `lo` to `hi`.
  float between(float lo, float hi) {
    bits_ = mix_bits(bits_);
    return lo + static_cast<float>(unit_pair(bits_).u) * (hi - lo);
  }

 private:
  std::uint64_t bits_;
};

}  // namespace asos::builtin
