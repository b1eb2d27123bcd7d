#pragma once

#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sampled_reflections.h"
#include "renderer/shading/background_along.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

namespace asos {

/// Collects the lights and reflections of one sample, or a part of them. One object per sample.
class OneSample final : public LightTransport {
 public:
  /// Rays to the sky from each surface that only its lobes are summed of. They use the sequence of
  /// as many samples.
  static constexpr std::uint32_t lobe_sky_rays = 4;

  /// `places` is at the sample.
  OneSample(SampledLights& lights, SampledReflections& reflections, const Shader& shader,
            const PointSample& sample, glm::vec3 weight, PixelSampler& places,
            SummedRadiance shows = SummedRadiance::all)
      : lights_(lights),
        reflections_(reflections),
        shader_(shader),
        sample_(sample),
        weight_(weight),
        places_(places),
        shows_(shows) {}

  HandledLights gather(const LightingQuery& point) override {
    if (shows_ == SummedRadiance::lobes) return {.all = true};
    const HandledLights taken =
        lights_.gather(point, {sample_.x, sample_.y, sample_.index}, target());
    return shows_ == SummedRadiance::all ? taken : HandledLights{.all = true};
  }
  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add(lit, target(), counts);
  }
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics& counts) override {
    if (shows_ == SummedRadiance::all) radiance += sky_by_ray(point, sample_.index, 1.0f, counts);
    if (shows_ == SummedRadiance::lobes) sky_ += sky_by_rays(point, counts);
    return true;
  }
  bool reflect(const Reflection& reflection, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    if (shows_ == SummedRadiance::all || (shows_ == SummedRadiance::lobes && reflection.lobe))
      reflections_.add(reflection, sample_, weight_, shader_);
    return true;
  }
  void note(LightPart part, glm::vec3 radiance) override {
    (part == LightPart::emission ? emission_ : background_) += radiance;
  }
  /// What was noted.
  [[nodiscard]] glm::vec3 emission() const { return emission_; }
  [[nodiscard]] glm::vec3 background() const { return background_; }
  /// Returns what to add to a sample if only lobes are summed.
  [[nodiscard]] glm::vec3 sky() const { return sky_; }

 private:
  [[nodiscard]] SampleWeight target() const { return {{sample_.target, sample_.part}, weight_}; }
  /// Adds a ray to the sky with the current place of the samples and this share of their weight.
  /// Returns what to add to the point's radiance, without the weight.
  glm::vec3 sky_by_ray(const SkyQuery& point, int index, float share, RenderStatistics& counts) {
    const SampleIndex sample{sample_.x, sample_.y, index};
    return lights_.add_sky(point, {{sample_.target, sample_.part}, share * weight_}, counts,
                           SampleStream::sky, shader_.settings().bounces ? &sample : nullptr);
  }
  glm::vec3 sky_by_rays(const SkyQuery& point, RenderStatistics& counts) {
    constexpr float share = 1.0f / lobe_sky_rays;
    const auto index = static_cast<std::uint32_t>(sample_.index);
    glm::vec3 sky(0.0f);
    for (std::uint32_t k = 0; k < lobe_sky_rays; ++k) {
      const auto i = static_cast<int>(lobe_sky_rays * index + k);
      places_.start_sample(i);
      sky += share * sky_by_ray(point, i, share, counts);
    }
    places_.start_sample(sample_.index);
    return sky;
  }

  SampledLights& lights_;
  SampledReflections& reflections_;
  const Shader& shader_;
  const PointSample& sample_;
  glm::vec3 weight_;
  PixelSampler& places_;
  SummedRadiance shows_;
  glm::vec3 emission_{0.0f};
  glm::vec3 background_{0.0f};
  glm::vec3 sky_{0.0f};
};

/// Adds the background to a sample whose ray hits nothing. Returns false, without adding anything,
/// if the ray needs Shader, which also counts radiance that is not finite.
[[nodiscard]] inline bool add_background(const Shader& shader, const PointSample& sample,
                                         glm::vec3 weight, const ViewedRay& seen,
                                         RadianceSums sums) {
  if (seen.hit.valid() || !shader.settings().backdrop.shows_light()) return false;
  if (seen.reflected() && !seen.hides_lights && shader.nearest_light_without_geometry(seen.ray))
    return false;
  const glm::vec3 radiance = weight * background_along(shader.settings(), seen);
  if (!std::isfinite(radiance.x + radiance.y + radiance.z)) return false;
  sums.add({sample.target, sample.part}, glm::dvec3(radiance), glm::dvec3(0.0),
           glm::dvec3(radiance));
  return true;
}

}  // namespace asos
