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
               PixelRect block, SamplePlaces& places, int samples)
      : scene_(scene),
        shader_(shader_of(scene, settings, view)),
        lights_(scene.rays, places),
        places_(places),
        faces_(seen_faces(settings)),
        sample_side_(1.0f / std::sqrt(static_cast<float>(samples))),
        block_(block),
        sums_(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height)),
        counts_(sums_.size(), 0) {}

  [[nodiscard]] bool full() const { return used_ == batch; }

  void add(const Ray& ray, std::size_t pixel, int index) {
    rays_[used_] = ray;
    indices_[used_] = index;
    pixels_[used_++] = pixel;
  }

  void trace() {
    scene_.rays.closest(std::span(rays_).first(used_), std::span(hits_).first(used_), faces_);
    statistics_.eye_rays += used_;
    for (std::size_t i = 0; i < used_; ++i) {
      start_place(i);
      lights_.set_target(pixels_[i]);
      const std::size_t waiting = lights_.waiting();
      const glm::vec3 radiance =
          shader_.radiance(rays_[i], hits_[i], sample_side_, lights_, statistics_);
      if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
        ++statistics_.rejected_samples;
        lights_.forget_since(waiting);
        continue;
      }
      sums_[pixels_[i]] += glm::dvec3(radiance);
      ++counts_[pixels_[i]];
    }
    lights_.trace(sums_);
    placed_ = -1;
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

  void start_place(std::size_t i) {
    const auto pixel = static_cast<int>(pixels_[i]);
    if (pixel != placed_) {
      places_.start_pixel(block_.x + pixel % block_.width, block_.y + pixel / block_.width);
      placed_ = pixel;
    }
    places_.start_sample(indices_[i]);
  }

  const RenderScene& scene_;
  Shader shader_;
  SampledLights lights_;
  SamplePlaces& places_;
  int placed_ = -1;
  Faces faces_;
  float sample_side_;  // in pixels
  PixelRect block_;
  std::vector<glm::dvec3> sums_;
  std::vector<std::uint32_t> counts_;
  RenderStatistics statistics_;
  std::array<Ray, batch> rays_;
  std::array<Hit, batch> hits_;
  std::array<std::size_t, batch> pixels_{};
  std::array<int, batch> indices_{};
  std::size_t used_ = 0;
};

}  // namespace

int grid_side(int spp) {
  int n = 1;
  while (n * n < spp) ++n;
  return n;
}

BlockResult sample_block(const RenderScene& scene, const View& view, const RenderSettings& settings,
                         PixelRect block, SamplePlaces& places, int samples,
                         const std::stop_token& stop) {
  BlockSampler sampler(scene, view, settings, block, places, samples);
  std::size_t pixel = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++pixel) {
      places.start_pixel(x, y);
      for (int index = 0; index < samples; ++index) {
        places.start_sample(index);
        const PixelPoint p = places.in_pixel();
        sampler.add(view.ray(x + p.x, y + p.y), pixel, index);
        if (!sampler.full()) continue;
        sampler.trace();
        if (stop.stop_requested()) return sampler.take();
        places.start_pixel(x, y);
      }
    }
  }
  sampler.trace();
  return sampler.take();
}

}  // namespace asos
