#include "renderer/samples/block_job.h"
#include "renderer/samples/pixel_layers.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_sampler.h"

#include <array>
#include <vector>

// "Replacing each pixel value by a (weighted) average of its neighbours" (CGF'98 section 2.1).

namespace asos {
namespace {

constexpr std::array<double, 3> weights{0.25, 0.5, 0.25};

/// The samples of a block's pixels and of the pixels around it, which may lie outside the picture.
class Neighbourhood {
 public:
  explicit Neighbourhood(PixelRect block)
      : x_(block.x - 1), y_(block.y - 1), width_(block.width + 2), height_(block.height + 2) {}

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  void take(SampleSums& sums, const std::stop_token& stop) const {
    sums.resize(size());
    for (int y = y_; y < y_ + height_; ++y) {
      for (int x = x_; x < x_ + width_; ++x) {
        if (sums.add({{x + 0.5, y + 0.5}, 1.0f, x, y, 0, index(x, y)}) && stop.stop_requested())
          return;
      }
    }
    sums.trace();
  }

  /// Returns the weighted mean of the finite samples among the 3 x 3 around a pixel of the block.
  [[nodiscard]] glm::vec3 mean(const SampleSums& sums, int x, int y) const {
    glm::dvec3 sum(0.0);
    double weight = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        const SampleSums::Sum sample =
            sums.sum(index(x + static_cast<int>(i) - 1, y + static_cast<int>(j) - 1));
        if (sample.count == 0) continue;
        const double share = weights[i] * weights[j];
        sum += share * sample.mean();
        weight += share;
      }
    }
    return weight > 0.0 ? glm::vec3(sum / weight) : glm::vec3(0.0f);
  }

  /// Returns the mean of the layers of the same samples.
  [[nodiscard]] LayerSum mean(const PixelLayers& layers, int x, int y) const {
    LayerSum sum;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        sum.add(layers.sum(index(x + static_cast<int>(i) - 1, y + static_cast<int>(j) - 1)),
                weights[i] * weights[j]);
    return sum;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x - x_);
  }

  int x_, y_, width_, height_;
};

}  // namespace

/// Averages 3 x 3 samples, one through each pixel's centre, with the weights 1 2 1 in each
/// direction (CGF'98 section 2.1). Pixels at the border use samples outside the picture. The other
/// variant of that section, the mean of rays through the pixel's corners, is `whitted` at depth 0.
BlockResult render_block_average(const BlockJob& job) {
  const PixelRect& block = job.block;
  SobolSampler places(job.settings.seed);
  SampleSums sums(job, places);
  const Neighbourhood neighbourhood(block);
  PixelLayers layers(job.settings, neighbourhood.size());
  layers.note_each(sums);
  neighbourhood.take(sums, job.stop);
  BlockResult result = sums.block(block);
  std::vector<LayerSum> means;
  std::size_t pixel = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++pixel) {
      result.tile.radiance[pixel] = neighbourhood.mean(sums, x, y);
      if (!layers.empty()) means.push_back(neighbourhood.mean(layers, x, y));
    }
  }
  if (!layers.empty()) result.tile.layers = planes_of(means, job.settings.layers);
  return result;
}

}  // namespace asos
