#include "renderer/methods/sample_sums.h"

#include <cmath>
#include <span>

namespace asos {

SampleSums::SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
                       SamplePlaces& places)
    : view_(view),
      scene_rays_(scene.rays),
      shader_(shader_of(scene, settings, view)),
      places_(places),
      lights_(scene.rays, places),
      faces_(seen_faces(settings)) {}

void SampleSums::resize(std::size_t count) {
  radiance_.resize(count, glm::dvec3(0.0));
  count_.resize(count, 0);
  hit_.resize(count);
}

bool SampleSums::add(const PointSample& sample) {
  samples_[used_] = sample;
  rays_[used_++] = view_.ray(sample.at.x, sample.at.y);
  if (used_ < batch) return false;
  trace();
  return true;
}

void SampleSums::trace() {
  scene_rays_.closest(std::span(rays_).first(used_), std::span(hits_).first(used_), faces_);
  statistics_.eye_rays += used_;
  for (std::size_t i = 0; i < used_; ++i) {
    const PointSample& sample = samples_[i];
    if (i == 0 || sample.x != samples_[i - 1].x || sample.y != samples_[i - 1].y)
      places_.start_pixel(sample.x, sample.y);
    places_.start_sample(sample.index);
    hit_[sample.target] = hits_[i];
    lights_.set_target(sample.target);
    const std::size_t waiting = lights_.waiting();
    const glm::vec3 radiance =
        shader_.radiance(rays_[i], hits_[i], sample.side, lights_, statistics_);
    if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
      ++statistics_.rejected_samples;
      lights_.forget_since(waiting);
      continue;
    }
    radiance_[sample.target] += glm::dvec3(radiance);
    ++count_[sample.target];
  }
  lights_.trace(radiance_);
  used_ = 0;
}

BlockResult SampleSums::block(PixelRect rect) const {
  BlockResult result;
  result.statistics = statistics_;
  result.tile.rect = rect;
  const auto pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  result.tile.radiance.reserve(pixels);
  result.tile.split_level.assign(pixels, 0);
  for (std::size_t i = 0; i < pixels; ++i) result.tile.radiance.emplace_back(sum(i).mean());
  return result;
}

}  // namespace asos
