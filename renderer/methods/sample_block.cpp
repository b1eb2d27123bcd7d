#include "renderer/methods/sample_block.h"

#include "renderer/shading/shade.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {
namespace {

/// The samples of a block's pixels, one pixel after the other, traced a batch at a time.
class BlockSampler {
 public:
  BlockSampler(const RenderScene& scene, const View& view, const RenderSettings& settings,
               PixelRect block)
      : scene_(scene),
        shader_(shader_of(scene, settings, view)),
        sample_side_(1.0f / static_cast<float>(grid_side(settings.spp))),
        block_(block),
        sums_(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height)),
        counts_(sums_.size(), 0) {}

  [[nodiscard]] bool full() const { return used_ == batch; }

  void add(const Ray& ray, std::size_t pixel) {
    rays_[used_] = ray;
    pixels_[used_++] = pixel;
  }

  void trace() {
    scene_.rays.closest(std::span(rays_).first(used_), std::span(hits_).first(used_));
    statistics_.eye_rays += used_;
    for (std::size_t i = 0; i < used_; ++i) {
      const glm::vec3 radiance = shader_.radiance(rays_[i], hits_[i], sample_side_, statistics_);
      if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
        ++statistics_.rejected_samples;
        continue;
      }
      sums_[pixels_[i]] += glm::dvec3(radiance);
      ++counts_[pixels_[i]];
    }
    used_ = 0;
  }

  [[nodiscard]] BlockResult take() {
    BlockResult result;
    result.statistics = statistics_;
    result.tile.rect = block_;
    result.tile.radiance.reserve(sums_.size());
    result.tile.split_level.assign(sums_.size(), 0);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      result.tile.radiance.push_back(
          counts_[i] > 0 ? glm::vec3(sums_[i] / static_cast<double>(counts_[i])) : glm::vec3(0.0f));
    }
    return result;
  }

 private:
  static constexpr std::size_t batch = 256;

  const RenderScene& scene_;
  Shader shader_;
  float sample_side_;  // in pixels
  PixelRect block_;
  std::vector<glm::dvec3> sums_;
  std::vector<std::uint32_t> counts_;
  RenderStatistics statistics_;
  std::array<Ray, batch> rays_;
  std::array<Hit, batch> hits_;
  std::array<std::size_t, batch> pixels_{};
  std::size_t used_ = 0;
};

}  // namespace

int grid_side(int spp) {
  int n = 1;
  while (n * n < spp) ++n;
  return n;
}

BlockResult sample_block(const RenderScene& scene, const View& view, const RenderSettings& settings,
                         PixelRect block, PlaceSample place, const std::stop_token& stop) {
  const int n = grid_side(settings.spp);
  BlockSampler sampler(scene, view, settings, block);
  std::size_t pixel = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++pixel) {
      for (int index = 0; index < n * n; ++index) {
        const PixelPoint p = place(x, y, index, n);
        sampler.add(view.ray(x + p.x, y + p.y), pixel);
        if (!sampler.full()) continue;
        sampler.trace();
        if (stop.stop_requested()) return sampler.take();
      }
    }
  }
  sampler.trace();
  return sampler.take();
}

}  // namespace asos
