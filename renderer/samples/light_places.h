#pragma once

#include "renderer/kernels/light_kernel.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// A sample by its place in a picture's sequence.
struct SampleIndex {
  int x = 0;  ///< of its pixel
  int y = 0;
  int index = 0;

  [[nodiscard]] bool same_pixel(const SampleIndex& other) const {
    return x == other.x && y == other.y;
  }
};

/// Where on a light each sample of a pixel looks.
class LightPlaces {
 public:
  virtual ~LightPlaces() = default;
  /// In the unit square, of the sample that is under way.
  [[nodiscard]] virtual glm::dvec2 on_light(std::uint32_t light) const = 0;
  /// Where in a blurred reflection's square it looks at the given bounce, from 0: independent of
  /// where it looks on lights.
  [[nodiscard]] virtual glm::dvec2 in_lobe(int bounce) const {
    return on_light(0x4000u + static_cast<std::uint32_t>(bounce));
  }

  /// Goes to a batch of samples, at most LitBatch::size of them, which have to outlive what is
  /// asked about them. The sample under way is another one then.
  virtual void start_batch(std::span<const SampleIndex> samples) = 0;
  /// Of each sample of the batch: `on_light` as 32-bit fractions.
  virtual void on_light(std::uint32_t light, LightPlaceBatch& places) = 0;
};

}  // namespace asos
