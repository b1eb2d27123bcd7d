#pragma once

#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sampled_reflections.h"
#include "renderer/shading/background_along.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

namespace asos {

/// Collects the lights and reflections of one sample. One object per sample.
class OneSample : public LightTransport {
 public:
  OneSample(SampledLights& lights, SampledReflections& reflections, const Shader& shader,
            const PointSample& sample, glm::vec3 weight)
      : lights_(lights),
        reflections_(reflections),
        shader_(shader),
        sample_(sample),
        weight_(weight) {}

  HandledLights gather(const LightingQuery& point) override {
    return lights_.gather(point, {sample_.x, sample_.y, sample_.index}, target());
  }
  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    lights_.add(lit, target(), counts);
  }
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics& counts) override {
    radiance += sky_by_ray(point, sample_.index, weight_, counts);
    return true;
  }
  bool reflect(const Reflection& reflection, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    reflections_.add(reflection, sample_, weight_, shader_);
    return true;
  }
  void note(LightPart part, glm::vec3 radiance) override {
    (part == LightPart::emission ? emission_ : background_) += radiance;
  }
  /// What was noted.
  [[nodiscard]] glm::vec3 emission() const { return emission_; }
  [[nodiscard]] glm::vec3 background() const { return background_; }

 protected:
  /// Adds a ray to the sky with the current place of the samples. Returns what to add to the
  /// point's radiance, without the weight.
  glm::vec3 sky_by_ray(const SkyQuery& point, int index, glm::vec3 weight,
                       RenderStatistics& counts) {
    const SampleIndex sample{sample_.x, sample_.y, index};
    return lights_.add_sky(point, {{sample_.target, sample_.part}, weight}, counts,
                           SampleStream::sky, shader_.settings().bounces ? &sample : nullptr);
  }
  [[nodiscard]] const PointSample& sample() const { return sample_; }

 private:
  [[nodiscard]] SampleWeight target() const { return {{sample_.target, sample_.part}, weight_}; }

  SampledLights& lights_;
  SampledReflections& reflections_;
  const Shader& shader_;
  const PointSample& sample_;
  glm::vec3 weight_;
  glm::vec3 emission_{0.0f};
  glm::vec3 background_{0.0f};
};

/// Collects only what the first surfaces of a sample reflect by lobes: reflections, and the sky if
/// it may be occluded.
class OneLobeSample final : public OneSample {
 public:
  /// Rays to the sky from each surface. They use the sequence of as many samples.
  static constexpr std::uint32_t sky_rays = 4;

  /// `places` is at the sample.
  OneLobeSample(SampledLights& lights, SampledReflections& reflections, const Shader& shader,
                const PointSample& sample, PixelSampler& places)
      : OneSample(lights, reflections, shader, sample, glm::vec3(1.0f)), places_(places) {}

  HandledLights gather(const LightingQuery& /*point*/) override { return {.all = true}; }
  bool add_sky(const SkyQuery& point, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    constexpr float weight = 1.0f / sky_rays;
    const auto index = static_cast<std::uint32_t>(sample().index);
    for (std::uint32_t k = 0; k < sky_rays; ++k) {
      const auto i = static_cast<int>(sky_rays * index + k);
      places_.start_sample(i);
      sky_ += weight * sky_by_ray(point, i, glm::vec3(weight), counts);
    }
    places_.start_sample(sample().index);
    return true;
  }
  bool reflect(const Reflection& reflection, glm::vec3& radiance,
               RenderStatistics& counts) override {
    return reflection.lobe == nullptr || OneSample::reflect(reflection, radiance, counts);
  }
  /// Returns what to add to the sample's radiance.
  [[nodiscard]] glm::vec3 sky() const { return sky_; }

 private:
  PixelSampler& places_;
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
