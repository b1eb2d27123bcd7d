#include "renderer/asos/counted_lights.h"

namespace asos {

CountForLight::CountForLight(RenderStatistics& counts, std::uint32_t light)
    : counts_(counts),
      light_(light),
      rays_before_(counts.shadow_rays),
      pyrays_before_(counts.shadow_pyrays),
      light_before_(counts.of_light(light)) {}

CountForLight::~CountForLight() {
  const LightStatistics now = {
      light_before_.shadow_rays + counts_.shadow_rays - rays_before_,
      light_before_.shadow_pyrays + counts_.shadow_pyrays - pyrays_before_};
  if (now == light_before_) return;
  if (light_ >= counts_.lights.size()) counts_.lights.resize(light_ + std::size_t{1});
  counts_.lights[light_] = now;
}

void CountedLights::add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) {
  const glm::vec3 without = radiance;
  const glm::vec3 with = without + lit.reflected * lit.unshadowed;
  const CountForLight count(counts, lit.index);
  inner_.add(lit, radiance, counts);
  const bool in_part = radiance != without && radiance != with;
  met_shadow_edge_ |= in_part && count.rays() > 1 && !lit.light.extended();
}

}  // namespace asos
