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

SampledLights::Gathered& SampledLights::first_points() {
  if (batches_.empty()) batches_.push_back(Recycler<Gathered>::make());
  return *batches_.front();
}

void SampledLights::gathered(std::size_t points, std::span<const PreparedLight> lights,
                             bool shadows) {
  prepare(lights, shadows);
  points_ = points;
}

void SampledLights::prepare(std::span<const PreparedLight> lights, bool shadows) {
  if (!lights_.empty()) return;
  for (const PreparedLight& light : lights) lights_.emplace_back(light);
  shadows_ = shadows;
}

void SampledLights::gather(const LitPoint& point, const SampleIndex& sample,
                           const SampleShare& share) {
  prepare(point.lights, point.shadows);
  const std::size_t batch = points_ / LitBatch::size;
  if (batch == batches_.size()) batches_.push_back(Recycler<Gathered>::make());
  Gathered& gathered = *batches_[batch];
  const std::size_t i = points_++ % LitBatch::size;
  gathered.points.count = i;
  gathered.points.add(point, share.weight);
  gathered.samples[i] = sample;
  gathered.targets[i] = share.target;
}

void SampledLights::forget_since(const Waiting& then) {
  points_ = then.points;
  pending_.resize(then.rays);
}

void SampledLights::trace(std::vector<glm::dvec3>& sums, RenderStatistics& counts) {
  for (std::size_t first = 0; first < points_; first += LitBatch::size) {
    Gathered& batch = *batches_[first / LitBatch::size];
    batch.points.count = std::min(LitBatch::size, points_ - first);
    trace(batch, sums, counts);
  }
  points_ = 0;
  trace_pending(sums);
}

void SampledLights::trace(std::vector<glm::dvec3>& sums) {
  RenderStatistics none;
  trace(sums, none);
}

void SampledLights::trace(const Gathered& batch, std::vector<glm::dvec3>& sums,
                          RenderStatistics& counts) {
  places_->start_batch(std::span(batch.samples).first(batch.points.count));
  ShadowRayBatch& rays = shadow_rays_;
  for (std::uint32_t light = 0; light < lights_.size(); ++light) {
    const PreparedLight& prepared = *lights_[light].light;
    if (!is_gathered(prepared, shadows_)) continue;
    shares_.assign(LitBatch::size, 1.0f);
    if (shadows_ && prepared.casts_shadows) {
      if (prepared.extended()) places_->on_light(light, on_light_);
      shade_batch(batch.points, lights_[light], on_light_, rays);
      const std::size_t sent = rays.count + rays.rejected;
      if (sent > 0) counts.count_shadow_ray(light, sent);
      trace_shadows(prepared.own_part);
    } else {
      shade_unshadowed(batch.points, lights_[light], rays);
    }
    counts.rejected_samples += rays.rejected;
    for (std::size_t i = 0; i < rays.count; ++i) {
      const glm::vec3 carried(rays.carried[0][i], rays.carried[1][i], rays.carried[2][i]);
      sums[batch.targets[rays.point[i]]] += glm::dvec3(shares_[i] * carried);
    }
  }
}

void SampledLights::trace_shadows(std::int32_t own_part) {
  const ShadowRayBatch& rays = shadow_rays_;
  if (rays.count == 0) return;
  const auto arrays = [](const auto& of) {
    return std::array<const float*, 3>{of[0].data(), of[1].data(), of[2].data()};
  };
  rays_->transmittance(
      RayArrays{rays.count, arrays(rays.origin), arrays(rays.direction), rays.t_far.data()},
      std::span(shares_).first(rays.count), own_part);
}

void SampledLights::trace_pending(std::vector<glm::dvec3>& sums) {
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
