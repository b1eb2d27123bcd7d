#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/sampling/sample_streams.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// Identifies a sample of a picture by pixel and index.
struct SampleIndex {
  int x = 0;  ///< of its pixel
  int y = 0;
  int index = 0;

  [[nodiscard]] bool same_pixel(const SampleIndex& other) const {
    return x == other.x && y == other.y;
  }
};

/// Places on lights for each sample of a pixel.
class LightSamplePoints {
 public:
  virtual ~LightSamplePoints() = default;
  /// Returns the current sample's place on a light, in the unit square.
  [[nodiscard]] virtual glm::dvec2 on_light(std::uint32_t light) const = 0;
  /// Returns the current sample's place in number `k` of a stream from `reflections` on, in the
  /// unit square. It is independent of places on lights.
  [[nodiscard]] virtual glm::dvec2 in_lobe(SampleStream stream, int k) const {
    const std::uint32_t lobe =
        number_of(stream, static_cast<std::uint32_t>(k)) - number_of(SampleStream::reflections);
    return on_light(number_of(SampleStream::grid_lobes, lobe));
  }

  /// Starts a batch of at most ShadingPoints::size samples, which have to outlive its use. Changes
  /// the current sample.
  virtual void start_batch(std::span<const SampleIndex> samples) = 0;
  /// Computes `on_light` of each sample of the batch, as 32-bit fractions.
  virtual void on_light(std::uint32_t light, LightPointBatch& places) = 0;
  /// The same of the samples with these indices in the batch, which ascend. Their places are
  /// stored without gaps.
  virtual void on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                        LightPointBatch& places) = 0;
};

}  // namespace asos
