#pragma once

#include "renderer/film/block_result.h"
#include "renderer/film/layer_sums.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sample_sums.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace asos {

/// A block of pixels with the same number of point samples each, taken in rounds: 1, 2, 4 and so on
/// per pixel. Each round continues the sums of those before. Rounds are deterministic, whenever and
/// on whichever thread they run.
class PixelSamples {
 public:
  explicit PixelSamples(PixelRect block);

  /// Takes samples `taken()` to `end` of each pixel, with the footprint for `footprints` samples
  /// per pixel. After a stop request the result is incomplete and has to be discarded. `job.block`
  /// is the constructor's block.
  void advance(const BlockJob& job, PixelSampler& places, int end, int footprints);

  /// Returns the number of samples per pixel so far.
  [[nodiscard]] int taken() const { return taken_; }
  /// Returns the number of samples after the round that follows `taken` samples, out of `most` in
  /// total.
  [[nodiscard]] static int after_round(int taken, int most);

  /// Returns the memory in use.
  [[nodiscard]] std::size_t bytes() const {
    return sums_.capacity() * sizeof(sums_[0]) + moved_.capacity() * sizeof(moved_[0]) +
           layers_.capacity() * sizeof(layers_[0]);
  }

  /// Returns the means so far, and the work of all rounds.
  [[nodiscard]] BlockResult result() const;
  /// Returns by how much each pixel's mean changed in the last round: its squared distance in
  /// linear radiance clamped to 0..1, summed over the channels. 0 before there are two rounds.
  /// Row-major.
  [[nodiscard]] const std::vector<float>& moved() const { return moved_; }

 private:
  PixelRect block_;
  int taken_ = 0;
  std::vector<SampleSums::Sum> sums_;
  std::vector<float> moved_;
  LayerSet asked_;                // the job's layers
  std::vector<LayerSum> layers_;  // one a pixel; none where no surface layer is asked for
  RenderStatistics statistics_;
};

}  // namespace asos
