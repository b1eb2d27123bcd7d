#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/sampling/sobol_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The samples of a batch by their pixels and indices, for the places of all of them on a light:
/// bit for bit those of SobolPixel::light.
class SobolBatch {
 public:
  void clear();
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// The next sample of the batch, of which there are at most LitBatch::size. Those of a pixel that
  /// follow each other share its seeds.
  void add(const SobolPixel& pixel, std::uint32_t index);
  /// The next sample, of the pixel of the last one.
  void add(std::uint32_t index) {
    u_[count_] = mirrored_sobol_bits(2, index);
    v_[count_] = mirrored_sobol_bits(3, index);
    ++count_;
  }

  void on_light(std::uint32_t light, LightPlaceBatch& places) const;

 private:
  struct Run {
    SobolPixel pixel;
    std::size_t first;
  };
  std::size_t count_ = 0;
  std::vector<Run> runs_;
  LightPlaceBatch::Fractions u_{}, v_{};  ///< before they are scrambled, digits mirrored
};

/// SobolPixel::pixel, several samples at a time.
class SobolPixelPlaces {
 public:
  /// Before another pixel is asked for.
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

/// owen_scramble of fractions whose digits are mirrored. `scrambled` has room for a multiple of 16.
void scramble_mirrored(std::span<const std::uint32_t> mirrored, std::uint64_t seed,
                       std::uint32_t* scrambled);

}  // namespace asos
