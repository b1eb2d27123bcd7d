#include "renderer/comparison/ray_bound_pixels.h"
#include "renderer/samples/block_job.h"
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
  explicit BoundedBlock(const BlockJob& job)
      : job_(job),
        n_(grid_side(job.settings.sampling.spp)),
        pixels_(static_cast<std::size_t>(job.block.width) *
                static_cast<std::size_t>(job.block.height)),
        places_(n_, true),
        sums_(job, places_) {}

  BlockResult run() {
    sums_.resize(pixels_);
    take_centres();
    std::vector<std::uint8_t> bounded(pixels_, 0);
    if (n_ > 1 && !job_.stop.stop_requested()) {
      std::vector<Hit> hits;
      for (std::size_t pixel = 0; pixel < pixels_; ++pixel) hits.push_back(sums_.hit(pixel));
      // Blurred edges reach into many pixels.
      if (job_.view.has_lens() || job_.motion)
        bounded.assign(pixels_, 1);
      else
        bounded = pixels_with_boundaries(job_.scene, job_.view, job_.block, hits);
      supersample(bounded);
    }
    BlockResult result = sums_.block(job_.block);
    for (const std::uint8_t pixel : bounded) result.statistics.split_pixels += pixel;
    result.tile.split_level = std::move(bounded);
    return result;
  }

 private:
  // Returns the stratum whose sample is replaced by the centre's: a central one, which has the
  // pixel's centre as its own centre or as its corner.
  [[nodiscard]] int middle() const { return n_ / 2 * n_ + n_ / 2; }

  [[nodiscard]] int x_of(std::size_t pixel) const {
    return job_.block.x + static_cast<int>(pixel) % job_.block.width;
  }
  [[nodiscard]] int y_of(std::size_t pixel) const {
    return job_.block.y + static_cast<int>(pixel) / job_.block.width;
  }

  void take_centres() {
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      const int x = x_of(pixel), y = y_of(pixel);
      sums_.add({{x + 0.5, y + 0.5}, 1.0f, x, y, middle(), pixel});
    }
    sums_.trace();
  }

  void supersample(const std::vector<std::uint8_t>& bounded) {
    const float side = 1.0f / static_cast<float>(n_);
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      if (!bounded[pixel]) continue;
      const int x = x_of(pixel), y = y_of(pixel);
      for (int index = 0; index < n_ * n_; ++index) {
        if (index == middle()) continue;
        places_.start_pixel(x, y);
        places_.start_sample(index);
        const PixelPoint p = places_.in_pixel();
        if (sums_.add({{x + p.x, y + p.y}, side, x, y, index, pixel}) && job_.stop.stop_requested())
          return;
      }
    }
    sums_.trace();
  }

  BlockJob job_;
  int n_;
  std::size_t pixels_;
  GridSampler places_;
  SampleSums sums_;
};

}  // namespace

/// Ray bound tracing (Ohta and Maekawa 1990; CGF'98 section 2.9): n x n jittered samples, as many
/// as `uniform` would take, in pixels with an object's boundary (pixels_with_boundaries), and one
/// through the centre in the others. With a lens or motion blur all pixels are supersampled. The
/// centre's sample is one of the n x n: it stands in for that of a middle stratum. Eye rays only:
/// boundaries of shadows are not looked for.
BlockResult render_block_ray_bound(const BlockJob& job) {
  return BoundedBlock(job).run();
}

}  // namespace asos
