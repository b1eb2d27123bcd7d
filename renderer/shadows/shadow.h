#pragma once

#include "renderer/film/statistics.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>

namespace asos {

/// Counts all shadow rays and pyrays during its lifetime for one light.
class CountForLight {
 public:
  CountForLight(RenderStatistics& counts, std::uint32_t light);
  ~CountForLight();
  CountForLight(const CountForLight&) = delete;
  CountForLight& operator=(const CountForLight&) = delete;

 private:
  RenderStatistics& counts_;
  std::uint32_t light_;
  std::uint64_t rays_before_;
  std::uint64_t pyrays_before_;
  LightStatistics light_before_;
};

/// Computes the visibility of a light from a leaf's patch, 0 to 1, by pyrays between light and
/// patch (CGF'98 section 4); this is how ASOS finds shadows. Its cost is in shadow rays. If no
/// boundary lies between a group of coplanar points and a light, one ray decides for all of them.
[[nodiscard]] Estimate light_visibility(const ShadowContext& block, const Illumination& lit,
                                        const Leaf& leaf, RenderStatistics& counts);

/// Returns the visibility by one ray to a random point of the light: 0 or 1, or the transmittance
/// along the ray.
[[nodiscard]] Estimate ray_visibility(const ShadowContext& block, const ShadowQuery& query,
                                      RenderStatistics& counts);

}  // namespace asos
