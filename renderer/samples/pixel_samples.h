#pragma once

#include "renderer/film/block_result.h"
#include "renderer/film/layer_sums.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sample_sums.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A pixel that continues its samples.
struct ContinuedPixel {
  int x = 0, y = 0;  ///< of the picture
  int taken = 0;     ///< number of its samples so far
  SampleSums::Sum sum;
  LayerSum* layers = nullptr;  ///< of the job's layers of surfaces, if there are any
};

/// Takes samples `taken` to `end` of each pixel, with the footprint for `footprints` samples per
/// pixel. The pixels may lie anywhere in the picture, so that they fill packets of rays. Samples
/// depend on their pixel only, and not on the others. After a stop request the sums are incomplete
/// and have to be discarded.
[[nodiscard]] RenderStatistics continue_pixels(const BlockJob& job, PixelSampler& places,
                                               std::span<ContinuedPixel> pixels, int end,
                                               int footprints);

/// A block of pixels with point samples, taken in rounds: 1, 2, 4 and so on per pixel. Each round
/// continues the sums of those before. Single pixels may continue alone. Rounds are deterministic,
/// whenever and on whichever thread they run.
class PixelSamples {
 public:
  explicit PixelSamples(PixelRect block);

  /// Takes samples `taken()` to `end` of each pixel (continue_pixels). `job.block` is the
  /// constructor's block.
  void advance(const BlockJob& job, PixelSampler& places, int end, int footprints);

  /// Returns the number of samples that `advance` took of each pixel.
  [[nodiscard]] int taken() const { return taken_; }
  /// Returns the number of samples after the round that follows `taken` samples, out of `most` in
  /// total.
  [[nodiscard]] static int after_round(int taken, int most);

  /// Returns the place of a pixel of the picture.
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - block_.y) * static_cast<std::size_t>(block_.width) +
           static_cast<std::size_t>(x - block_.x);
  }
  [[nodiscard]] std::size_t pixel_count() const { return pixels_.size(); }
  /// Returns the number of samples of a pixel.
  [[nodiscard]] int taken(std::size_t pixel) const { return pixels_[pixel].taken; }
  [[nodiscard]] const SampleSums::Sum& sum(std::size_t pixel) const { return pixels_[pixel].sum; }
  /// Returns the layers of a pixel; null where no surface layer is asked for.
  [[nodiscard]] const LayerSum* layers(std::size_t pixel) const {
    return layers_.empty() ? nullptr : &layers_[pixel];
  }
  /// Replaces the samples of a pixel by those that continue them, `taken` in all.
  void put(std::size_t pixel, int taken, const SampleSums::Sum& sum, const LayerSum* layers);

  /// Returns the memory in use.
  [[nodiscard]] std::size_t bytes() const {
    return pixels_.capacity() * sizeof(pixels_[0]) + layers_.capacity() * sizeof(layers_[0]);
  }

  /// Returns the means so far, and the work of all rounds.
  [[nodiscard]] BlockResult result() const;
  /// Returns the means of a part of the block.
  [[nodiscard]] FinishedTile tile(const PixelRect& part) const;
  /// Returns by how much a pixel's mean has changed since it had a quarter of its samples, or the
  /// next smaller power of four: its squared distance in linear radiance clamped to 0..1, summed
  /// over the channels. 0 before the second sample.
  [[nodiscard]] float moved(std::size_t pixel) const { return pixels_[pixel].moved; }
  /// Returns the sum of `moved` over all pixels.
  [[nodiscard]] double moved() const;

 private:
  struct Pixel {
    SampleSums::Sum sum;
    int taken = 0;
    float moved = 0.0f;
    glm::vec3 before{0.0f};  // shown at the last power of four
  };

  PixelRect block_;
  int taken_ = 0;
  std::vector<Pixel> pixels_;
  LayerSet asked_;                // the job's layers
  std::vector<LayerSum> layers_;  // one a pixel; none where no surface layer is asked for
  RenderStatistics statistics_;
};

}  // namespace asos
