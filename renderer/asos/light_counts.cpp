#include "renderer/asos/light_counts.h"

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

}  // namespace asos
