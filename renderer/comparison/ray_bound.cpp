#include "renderer/comparison/ray_bound_pixels.h"
#include "renderer/samples/sample_sums.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Ray bound tracing (CGF'98 section 2.9): where a boundary is near, "the pixel is supersampled at
// some predetermined value".

namespace asos {
namespace {

class BoundedBlock {
 public:
  BoundedBlock(const RenderScene& scene, const View& view, const RenderSettings& settings,
               PixelRect block)
      : scene_(scene),
        view_(view),
        block_(block),
        n_(grid_side(settings.sampling.spp)),
        pixels_(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height)),
        places_(n_, true),
        sums_(scene, view, settings, places_) {}

  BlockResult run(const std::stop_token& stop) {
    sums_.resize(pixels_);
    take_centres();
    std::vector<std::uint8_t> bounded(pixels_, 0);
    if (n_ > 1 && !stop.stop_requested()) {
      std::vector<Hit> hits;
      for (std::size_t pixel = 0; pixel < pixels_; ++pixel) hits.push_back(sums_.hit(pixel));
      bounded = pixels_with_boundaries(scene_, view_, block_, hits);
      supersample(bounded, stop);
    }
    BlockResult result = sums_.block(block_);
    for (const std::uint8_t pixel : bounded) result.statistics.split_pixels += pixel;
    result.tile.split_level = std::move(bounded);
    return result;
  }

 private:
  // The stratum whose sample is the centre's: one in the middle, which has the centre as its own
  // middle or as its corner.
  [[nodiscard]] int middle() const { return n_ / 2 * n_ + n_ / 2; }

  [[nodiscard]] int x_of(std::size_t pixel) const {
    return block_.x + static_cast<int>(pixel) % block_.width;
  }
  [[nodiscard]] int y_of(std::size_t pixel) const {
    return block_.y + static_cast<int>(pixel) / block_.width;
  }

  void take_centres() {
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      const int x = x_of(pixel), y = y_of(pixel);
      sums_.add({{x + 0.5, y + 0.5}, 1.0f, x, y, middle(), pixel});
    }
    sums_.trace();
  }

  void supersample(const std::vector<std::uint8_t>& bounded, const std::stop_token& stop) {
    const float side = 1.0f / static_cast<float>(n_);
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      if (!bounded[pixel]) continue;
      const int x = x_of(pixel), y = y_of(pixel);
      for (int index = 0; index < n_ * n_; ++index) {
        if (index == middle()) continue;
        places_.start_pixel(x, y);
        places_.start_sample(index);
        const PixelPoint p = places_.in_pixel();
        if (sums_.add({{x + p.x, y + p.y}, side, x, y, index, pixel}) && stop.stop_requested())
          return;
      }
    }
    sums_.trace();
  }

  const RenderScene& scene_;
  const View& view_;
  PixelRect block_;
  int n_;
  std::size_t pixels_;
  GridPlaces places_;
  SampleSums sums_;
};

}  // namespace

BlockResult render_block_ray_bound(const RenderScene& scene, const View& view,
                                   const RenderSettings& settings, PixelRect block,
                                   const std::stop_token& stop) {
  return BoundedBlock(scene, view, settings, block).run(stop);
}

}  // namespace asos
