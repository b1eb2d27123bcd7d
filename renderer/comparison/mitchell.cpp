#include "renderer/film/tone.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/pixel_layers.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

// Two-level sampling by contrast (Mitchell 1987, "Generating antialiased images at low sampling
// densities", section 4).

namespace asos {
namespace {

constexpr int most_base_samples = 4;
/// Mitchell's contrast thresholds of red, green and blue.
constexpr glm::dvec3 thresholds{0.4, 0.3, 0.6};

class TwoLevels {
 public:
  explicit TwoLevels(const BlockJob& job)
      : block_(job.block),
        stop_(job.stop),
        judged_(job.settings.judged_tone),
        scale_(job.settings.sampling.contrast_scale),
        base_(std::min(most_base_samples, job.settings.sampling.spp)),
        high_(job.settings.sampling.spp),
        pixels_(static_cast<std::size_t>(block_.width) * static_cast<std::size_t>(block_.height)),
        places_(job.settings.seed),
        sums_(job, places_),
        layers_(job.settings, pixels_) {}

  // Sums 0 to pixels_ - 1 hold the additional samples of each pixel. The base samples follow, one
  // sum each.
  BlockResult run() {
    sums_.resize(pixels_ * static_cast<std::size_t>(1 + base_));
    std::vector<std::size_t> pixel_of_sum(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i)
      pixel_of_sum[i] = i < pixels_ ? i : (i - pixels_) / static_cast<std::size_t>(base_);
    layers_.note(pixel_of_sum, 1, sums_);
    if (take_base() && high_ > base_) take_more();
    BlockResult result = sums_.block(block_);
    result.tile.layers = layers_.planes();
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      result.tile.radiance[pixel] = glm::vec3(whole(pixel).mean());
      result.tile.split_level[pixel] = contrasting_.empty() ? std::uint8_t{0} : contrasting_[pixel];
      result.statistics.split_pixels += result.tile.split_level[pixel];
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t base_sum(std::size_t pixel, int index) const {
    return pixels_ + pixel * static_cast<std::size_t>(base_) + static_cast<std::size_t>(index);
  }

  [[nodiscard]] bool take_base() {
    const float side = 1.0f / std::sqrt(static_cast<float>(base_));
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      for (int index = 0; index < base_; ++index) {
        if (add(pixel, index, side, base_sum(pixel, index)) && stop_.stop_requested()) return false;
      }
    }
    sums_.trace();
    return !stop_.stop_requested();
  }

  void take_more() {
    const float side = 1.0f / std::sqrt(static_cast<float>(high_));
    contrasting_.resize(pixels_);
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      contrasting_[pixel] = contrasts(pixel);
      if (!contrasting_[pixel]) continue;
      for (int index = base_; index < high_; ++index) {
        if (add(pixel, index, side, pixel) && stop_.stop_requested()) return;
      }
    }
    sums_.trace();
  }

  bool add(std::size_t pixel, int index, float side, std::size_t target) {
    const auto i = static_cast<int>(pixel);
    const int x = block_.x + i % block_.width;
    const int y = block_.y + i / block_.width;
    places_.start_pixel(x, y);
    places_.start_sample(index);
    const PixelPoint p = places_.in_pixel();
    return sums_.add({{x + p.x, y + p.y}, side, x, y, index, target});
  }

  // Returns whether (max - min) / (max + min) of the base samples reaches the threshold of some
  // channel.
  [[nodiscard]] bool contrasts(std::size_t pixel) const {
    if (scale_ == 0.0) return true;
    glm::dvec3 lo(0.0), hi(0.0);
    bool first = true;
    for (int index = 0; index < base_; ++index) {
      const SampleSums::Sum sample = sums_.sum(base_sum(pixel, index));
      if (sample.count == 0) continue;
      const glm::dvec3 shown = judged_ == ToneCurve::none
                                   ? sample.radiance
                                   : displayed_intensity(sample.radiance, judged_);
      lo = first ? shown : glm::min(lo, shown);
      hi = first ? shown : glm::max(hi, shown);
      first = false;
    }
    for (int c = 0; c < 3; ++c) {
      if (hi[c] > lo[c] && hi[c] - lo[c] >= scale_ * thresholds[c] * (hi[c] + lo[c])) return true;
    }
    return false;
  }

  [[nodiscard]] SampleSums::Sum whole(std::size_t pixel) const {
    SampleSums::Sum all = sums_.sum(pixel);
    for (int index = 0; index < base_; ++index) {
      const SampleSums::Sum sample = sums_.sum(base_sum(pixel, index));
      all.radiance += sample.radiance;
      all.count += sample.count;
    }
    return all;
  }

  PixelRect block_;
  std::stop_token stop_;
  ToneCurve judged_;
  double scale_;
  int base_;
  int high_;
  std::size_t pixels_;
  SobolSampler places_;
  SampleSums sums_;
  PixelLayers layers_;
  std::vector<std::uint8_t> contrasting_;
};

}  // namespace

/// Two-level sampling (Mitchell 1987) with `settings.sampling.spp` Sobol points. Takes the first
/// four points, and the others only if (max - min) / (max + min) of those four reaches
/// `settings.sampling.contrast_scale` times 0.4, 0.3 or 0.6 in red, green or blue. The colours are
/// linear (Mitchell's rule), or displayed by the curve `settings.judged_tone`, if it is set.
/// Differences from Mitchell: each pixel decides by its own samples and not by its neighbours'; all
/// its samples have equal weights; the filter is the pixel's box, while his cells hold eight or
/// nine samples and his filter is wider. With up to four samples it is equal to `sobol`.
BlockResult render_block_mitchell(const BlockJob& job) {
  return TwoLevels(job).run();
}

}  // namespace asos
