#include "renderer/samples/sampled_lights.h"

#include "renderer/shading/shadow_ray.h"

#include <algorithm>
#include <cmath>

namespace asos {

void SampledLights::add(const Illumination& lit, const SampleShare& share,
                        RenderStatistics& counts) {
  const glm::dvec2 at = places_->on_light(lit.index);
  const LightSample sample = sample_light(lit.light, receiver_at(lit.point), at.x, at.y);
  const glm::vec3 carried = share.weight * lit.reflected * sample.irradiance;
  if (carried == glm::vec3(0.0f)) return;
  counts.count_shadow_ray(lit.index);
  if (!std::isfinite(carried.x + carried.y + carried.z)) {
    ++counts.rejected_samples;
    return;
  }
  pending_.push_back({shadow_ray(lit.point, sample), carried, share.target, lit.light.own_part});
}

void SampledLights::trace(std::vector<glm::dvec3>& sums) {
  // Rays of one light follow each other's lead; a light's own part is one for all its rays.
  std::stable_sort(pending_.begin(), pending_.end(), [](const Pending& a, const Pending& b) {
    return a.ignored_part < b.ignored_part;
  });
  for (std::size_t first = 0; first < pending_.size();) {
    std::size_t end = first;
    while (end < pending_.size() && pending_[end].ignored_part == pending_[first].ignored_part)
      ++end;
    batch_.clear();
    for (std::size_t i = first; i < end; ++i) batch_.push_back(pending_[i].ray);
    shares_.resize(batch_.size());
    rays_->transmittance(batch_, shares_, pending_[first].ignored_part);
    for (std::size_t i = first; i < end; ++i)
      sums[pending_[i].target] += glm::dvec3(shares_[i - first] * pending_[i].carried);
    first = end;
  }
  pending_.clear();
}

}  // namespace asos
