#include "renderer/samples/bounced_light.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// Collects the lights and the sky at a surface that a ray hit, without reflections. One object per
/// surface.
class OneBounce final : public LightTransport {
 public:
  OneBounce(SampledLights& lights, const SkyRay& from) : lights_(lights), from_(from) {}

  HandledLights gather(const LightingQuery& point) override {
    return lights_.gather(point, from_.sample, share());
  }
  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add(lit, share(), counts);
  }
  bool add_sky(const SkyQuery& point, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add_sky(point, share(), counts, SampleStream::sky_of_bounce);
    return true;
  }

 private:
  [[nodiscard]] SampleWeight share() const { return {from_.target, from_.weight}; }

  SampledLights& lights_;
  const SkyRay& from_;
};

}  // namespace

void BouncedLight::follow(std::span<const SkyRay> rays, SampledLights& lights, RadianceSums sums,
                          RenderStatistics& counts) {
  if (rays.empty()) return;
  rays_.clear();
  for (const SkyRay& from : rays) rays_.push_back(from.ray);
  hits_.resize(rays.size());
  scene_->rays().closest(rays_, hits_);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const SkyRay& from = rays[i];
    counts.count_sample(hits_[i].valid() ? SamplePath::bounce : SamplePath::background);
    places_->start_pixel(from.sample.x, from.sample.y);
    places_->start_sample(from.sample.index);
    ViewedRay seen{from.ray, hits_[i]};
    // No reflections are followed at the hit, and lights are sampled separately.
    seen.bounces = std::max(1, shader_->reflections());
    seen.hides_lights = seen.diffuse = true;
    const SampledLights::Waiting before = lights.waiting();
    OneBounce transport(lights, from);
    const glm::vec3 radiance = from.weight * shader_->radiance(seen, transport, counts);
    if (std::isfinite(radiance.x + radiance.y + radiance.z)) {
      sums.add(from.target, glm::dvec3(radiance));
    } else {
      ++counts.rejected_samples;
      lights.forget_since(before);
    }
  }
}

}  // namespace asos
