#pragma once

#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sampled_reflections.h"
#include "renderer/shading/background_along.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// Collects the lights and reflections of one sample. One object per sample.
class OneSample final : public LightTransport {
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
  bool add_sky(const SkyQuery& point, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    const SampleWeight share = target();
    if (shader_.settings().bounces) {
      lights_.add_sky_ray(point, {sample_.x, sample_.y, sample_.index}, share, counts);
    } else {
      lights_.add_sky(point, share, counts);
    }
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

/// Collects only the lobes' reflections at the first surfaces of a sample.
class OneLobeSample final : public LightTransport {
 public:
  OneLobeSample(SampledReflections& reflections, const Shader& shader, const PointSample& sample)
      : reflections_(reflections), shader_(shader), sample_(sample) {}

  HandledLights gather(const LightingQuery& /*point*/) override { return {.all = true}; }
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {}
  bool add_sky(const SkyQuery& /*point*/, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    return true;
  }
  bool reflect(const Reflection& reflection, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    if (reflection.lobe) reflections_.add(reflection, sample_, glm::vec3(1.0f), shader_);
    return true;
  }

 private:
  SampledReflections& reflections_;
  const Shader& shader_;
  const PointSample& sample_;
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
