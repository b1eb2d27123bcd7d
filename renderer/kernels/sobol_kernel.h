#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/sampling/sobol_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Computes the places of a batch's samples on a light. Samples are identified by pixel and index.
/// The places equal those of SobolPixel::light, bit for bit.
class SobolBatch {
 public:
  void clear();
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Adds a sample; a batch has at most ShadingPoints::size. Successive samples of a pixel share
  /// its seeds.
  void add(const SobolPixel& pixel, std::uint32_t index);
  /// Adds a sample of the same pixel as the last one.
  void add(std::uint32_t index) {
    u_[count_] = mirrored_sobol_bits(SobolDimension::light_u, index);
    v_[count_] = mirrored_sobol_bits(SobolDimension::light_v, index);
    ++count_;
  }

  void on_light(std::uint32_t light, LightPointBatch& places) const;
  /// The same of the samples with these indices in the batch, which ascend. Their places are
  /// stored without gaps.
  void on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                LightPointBatch& places) const;

 private:
  struct Run {
    SobolPixel pixel;
    std::size_t first;
  };
  std::size_t count_ = 0;
  std::vector<Run> runs_;
  LightPointBatch::Fractions u_{}, v_{};  ///< before scrambling, with mirrored digits
};

/// SobolPixel::pixel for several samples at a time.
class SobolPixelSampler {
 public:
  /// Must be called whenever the pixel changes.
  void forget() { turn_ = none; }
  [[nodiscard]] glm::dvec2 at(const SobolPixel& pixel, std::uint32_t index) {
    if (index / per_turn != turn_) take_turn(pixel, index / per_turn);
    constexpr double scale = 1.0 / 4294967296.0;
    return {scale * u_[index % per_turn], scale * v_[index % per_turn]};
  }

 private:
  void take_turn(const SobolPixel& pixel, std::uint32_t turn);

  static constexpr std::uint32_t per_turn = 16;
  static constexpr std::uint32_t none = 0xffffffffu;
  std::uint32_t turn_ = none;
  std::array<std::uint32_t, per_turn> u_{}, v_{};
};

/// owen_scramble for fractions with mirrored digits. `scrambled` has room for a multiple of 16.
void scramble_mirrored(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
                       std::uint32_t* scrambled);

/// Fractions with mirrored digits, with a seed each.
struct SeededFractions {
  LightPointBatch::Fractions mirrored, low, high;  ///< 32 bits each of the seeds

  void set(std::size_t i, std::uint32_t fraction, std::uint64_t seed) {
    mirrored[i] = fraction;
    low[i] = static_cast<std::uint32_t>(seed);
    high[i] = static_cast<std::uint32_t>(seed >> 32);
  }
};
/// scramble_mirrored of the first `count` fractions, each by its own seed.
void scramble_mirrored(const SeededFractions& fractions, std::size_t count,
                       std::uint32_t* scrambled);

}  // namespace asos
