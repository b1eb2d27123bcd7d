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

/// The pixels of a block by the same number of point samples each, which come in rounds: 1, 2, 4
/// and so on a pixel. A round goes on from the sums of those before. The same rounds give the same
/// bits, whenever and by whichever thread each is taken.
class PixelSamples {
 public:
  explicit PixelSamples(PixelRect block);

  /// Takes the samples of each pixel from `taken()` up to `end`, each with the footprint of one of
  /// `footprints` samples of a pixel. Unfinished, and to be dropped, once the job's stop is
  /// requested. `job.block` is the block of the constructor.
  void advance(const BlockJob& job, SamplePlaces& places, int end, int footprints);

  /// The number of samples of each pixel so far.
  [[nodiscard]] int taken() const { return taken_; }
  /// The round that follows `taken` samples, of which there are `most` in the end: how many samples
  /// there are after it.
  [[nodiscard]] static int after_round(int taken, int most);

  /// Memory that it holds.
  [[nodiscard]] std::size_t bytes() const {
    return sums_.capacity() * sizeof(sums_[0]) + moved_.capacity() * sizeof(moved_[0]) +
           layers_.capacity() * sizeof(layers_[0]);
  }

  /// The means so far, and the work of all rounds.
  [[nodiscard]] BlockResult result() const;
  /// How far each pixel's mean moved in the latest round: its squared distance, of linear radiance
  /// clipped to 0..1, added up over the channels; 0 before there are two rounds. Row-major.
  [[nodiscard]] const std::vector<float>& moved() const { return moved_; }

 private:
  void note_layers(LayerSet asked, const LayerProbe& probe, SampleSums& sums);

  PixelRect block_;
  int taken_ = 0;
  std::vector<SampleSums::Sum> sums_;
  std::vector<float> moved_;
  LayerSet asked_;                // by the job
  std::vector<LayerSum> layers_;  // one a pixel; none where no surface layer is asked for
  RenderStatistics statistics_;
};

}  // namespace asos
