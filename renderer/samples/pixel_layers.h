#pragma once

#include "renderer/film/layer_sums.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/settings/settings.h"

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace asos {

/// The surface layers of a block's pixels as means over all of their samples. Empty where the
/// settings ask for none.
class PixelLayers {
 public:
  /// `settings` have to outlive this.
  PixelLayers(const RenderSettings& settings, std::size_t pixels)
      : settings_(&settings), sums_(settings.layers.of_surfaces() ? pixels : 0) {}
  PixelLayers(const PixelLayers&) = delete;
  PixelLayers& operator=(const PixelLayers&) = delete;

  /// Adds later samples to these pixels: pixel `pixels[k]` has the targets from `each` * k on.
  void note(std::span<const std::size_t> pixels, std::size_t each, SampleSums& samples) {
    if (sums_.empty()) return;
    targets_ = {};
    targets_.targets_each = each;
    for (const std::size_t pixel : pixels) targets_.add(sums_[pixel]);
    samples.note_layers(*settings_, targets_);
  }
  /// Adds later samples of target i to pixel i.
  void note_each(SampleSums& samples) {
    std::vector<std::size_t> pixels(sums_.size());
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    note(pixels, 1, samples);
  }
  [[nodiscard]] bool empty() const { return sums_.empty(); }
  [[nodiscard]] const LayerSum& sum(std::size_t pixel) const { return sums_[pixel]; }
  /// Drops all samples so far.
  void clear() { sums_.assign(sums_.size(), {}); }
  /// Returns the layers so far; none where the settings ask for none.
  [[nodiscard]] std::vector<LayerPlane> planes() const {
    return sums_.empty() ? std::vector<LayerPlane>() : planes_of(sums_, settings_->layers);
  }

 private:
  const RenderSettings* settings_;
  std::vector<LayerSum> sums_;  // of each pixel
  LayerTargets targets_;
};

}  // namespace asos
