#include "renderer/samples/sampled_lights.h"

#include "renderer/geometry/finite.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shading/shadow_ray.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

bool any_glossy(const ShadingPoints& points) {
  constexpr float broad = least_broad_roughness * least_broad_roughness;
  return std::any_of(points.alpha.begin(), points.alpha.begin() + points.count,
                     [](float alpha) { return alpha < broad; });
}

std::uint32_t binary_fraction(double at) {
  return static_cast<std::uint32_t>(0x1p32 * std::clamp(at, 0.0, 1.0 - 0x1p-32));
}

// Unshadowed lights with an extent have a closed form by the published rule.
bool taken(const PreparedLight& light, bool shadows) {
  return (shadows && light.casts_shadows) || !light.extended() || light.rule == LightRule::physical;
}

}  // namespace

bool SampledLights::takes_all(std::span<const PreparedLight> lights, bool shadows) {
  return std::all_of(lights.begin(), lights.end(),
                     [shadows](const PreparedLight& light) { return taken(light, shadows); });
}

void SampledLights::add(const Illumination& lit, const SampleWeight& share,
                        RenderStatistics& counts) {
  const glm::dvec2 at = places_->on_light(lit.index);
  const LightSample sample = sample_light(lit.light, receiver_at(lit.point), at.x, at.y);
  const glm::vec3 carried = share.weight * reflected_from(lit, sample) * sample.irradiance;
  if (carried == glm::vec3(0.0f)) return;
  counts.count_shadow_ray(lit.index);
  if (!std::isfinite(carried.x + carried.y + carried.z)) {
    ++counts.rejected_samples;
    return;
  }
  pending_.push_back({shadow_ray(lit.point, sample), carried, share.target, lit.light.own_part});
}

glm::vec3 SampledLights::add_sky(const SkyQuery& point, const SampleWeight& share,
                                 RenderStatistics& counts, SampleStream stream,
                                 const SampleIndex* continued) {
  const auto sample = sample_sky(point, places_->in_lobe(stream, 0));
  if (sample && sample->weight != glm::vec3(0.0f)) {
    ++counts.sky_rays;
    const glm::vec3 weight = share.weight * (continued ? sample->weight : sample->carried);
    if (!finite(weight)) {
      ++counts.rejected_samples;
      return glm::vec3(0.0f);
    }
    const Ray ray = sky_ray(point.view.point, *sample);
    if (continued) {
      sky_rays_.push_back({ray, weight, *continued, share.target});
    } else {
      pending_.push_back({ray, weight, share.target, -1});
    }
  }
  const glm::vec3 less = subtracts_open_sky_ ? open_sky_less(point, sample) : glm::vec3(0.0f);
  return finite(less) ? less : glm::vec3(0.0f);
}

SampledLights::Gathered& SampledLights::first_points() {
  if (batches_.empty()) batches_.push_back(ThreadLocalCache<Gathered>::make());
  return *batches_.front();
}

void SampledLights::gathered(std::size_t points) {
  points_ = points;
}

void SampledLights::prepare(std::span<const PreparedLight> lights, bool shadows) {
  if (!lights_.empty()) return;
  shadows_ = shadows;
  for (const PreparedLight& light : lights) {
    const std::size_t i = lights_.size();
    lights_.emplace_back(light);
    const bool takes = (allowed_.empty() || allowed_[i] != 0) && taken(light, shadows_);
    const bool shadowed = takes && shadows_ && light.casts_shadows;
    taken_.push_back(takes ? 1 : 0);
    shadowed_.push_back(shadowed ? 1 : 0);
    all_taken_ &= takes;
    lights_with_rays_ += shadowed;
  }
  if (!picks_lights()) return;
  for (std::uint32_t i = 0; i < lights_.size(); ++i)
    if (shadowed_[i] != 0) many_.emplace_back(lights_[i]), many_numbers_.push_back(i);
}

std::uint32_t SampledLights::pick_place() const {
  return binary_fraction(places_->in_lobe(SampleStream::light_choice, 0).x);
}

HandledLights SampledLights::gather(const LightingQuery& point, const SampleIndex& sample,
                                    const SampleWeight& share) {
  prepare(point.lights, point.shadows);
  const std::size_t batch = points_ / ShadingPoints::size;
  if (batch == batches_.size()) batches_.push_back(ThreadLocalCache<Gathered>::make());
  Gathered& gathered = *batches_[batch];
  const std::size_t i = points_++ % ShadingPoints::size;
  gathered.points.count = i;
  gathered.points.add(point, share.weight);
  gathered.samples[i] = sample;
  gathered.targets[i] = share.target;
  if (picks_lights()) gathered.picks[i] = pick_place();
  return {taken_, all_taken_};
}

void SampledLights::forget_since(const Waiting& then) {
  points_ = then.points;
  pending_.resize(then.rays);
  sky_rays_.resize(then.sky_rays);
}

void SampledLights::trace(RadianceSums sums, RenderStatistics& counts) {
  work_ = ThreadLocalCache<Work>::make();
  for (std::size_t first = 0; first < points_; first += ShadingPoints::size) {
    Gathered& batch = *batches_[first / ShadingPoints::size];
    batch.points.count = std::min(ShadingPoints::size, points_ - first);
    trace(batch, sums, counts);
  }
  points_ = 0;
  work_.reset();
  trace_pending(sums);
}

void SampledLights::trace(RadianceSums sums) {
  RenderStatistics none;
  trace(sums, none);
}

void SampledLights::trace(const Gathered& batch, RadianceSums sums, RenderStatistics& counts) {
  places_->start_batch(std::span(batch.samples).first(batch.points.count));
  const bool many = picks_lights();
  work_->arcs.resize(many ? 1 : lights_.size());
  for (LightArcs& known : work_->arcs) known.known = false;
  wide_.find(batch.points, lights_, many ? std::span<const std::uint8_t>() : shadowed_, *places_);
  trace_lobes(batch, sums, counts);
  trace_each(batch, sums, counts);
  if (many) trace_picked(batch, sums, counts);
}

LightArcs& SampledLights::arcs(std::uint32_t light) {
  if (!picks_lights()) return work_->arcs[light];
  work_->arcs.front().known = false;
  return work_->arcs.front();
}

// Traces the lights that every point samples.
void SampledLights::trace_each(const Gathered& batch, RadianceSums sums, RenderStatistics& counts) {
  for (std::uint32_t light = 0; light < lights_.size(); ++light) {
    if (picks_lights() && sends_rays(light)) continue;
    if (wide_.holds(light)) {
      for (const ShadowRayBatch& rays :
           wide_.shade(batch.points, batch.samples, light, lights_[light], *places_)) {
        counts.rejected_samples += rays.rejected;
        trace(batch, light, rays, sums, counts);
      }
      continue;
    }
    shade(batch, light, work_->rays);
    counts.rejected_samples += work_->rays.rejected;
    trace(batch, light, work_->rays, sums, counts);
  }
}

// Traces the stochastically selected lights.
void SampledLights::trace_picked(const Gathered& batch, RadianceSums sums,
                                 RenderStatistics& counts) {
  ShadowRayBatch& rays = work_->rays;
  LightSelection& picks = work_->picks;
  ShadingPoints& picked = work_->picked;
  LightPointBatch& places = work_->places;
  picks.pick(many_, batch.points, batch.picks);
  // A pixel's rays to a light use its first places on that light, which are well distributed
  // together.
  std::array<std::uint32_t, ShadingPoints::size> first_of_pixel, numbers;
  for (std::uint32_t p = 0; p < batch.points.count; ++p) {
    const bool same = p > 0 && batch.samples[p].same_pixel(batch.samples[p - 1]);
    first_of_pixel[p] = same ? first_of_pixel[p - 1] : p;
  }
  for (std::size_t i = 0; i < many_.size(); ++i) {
    const LightSelection::Points by = picks.of(i);
    if (by.point.empty()) continue;
    const std::uint32_t light = many_numbers_[i];
    picked.gather(batch.points, by.point);
    if (lights_[light].light->extended()) {
      std::uint32_t next = 0;
      for (std::size_t k = 0; k < by.point.size(); ++k) {
        numbers[k] = std::max(next, first_of_pixel[by.point[k]]);
        next = numbers[k] + 1;
      }
      places_->on_light(light, std::span(numbers).first(by.point.size()), places);
    }
    shade_batch(picked, lights_[light], places, rays);
    for (std::size_t k = 0; k < rays.count; ++k) {
      const std::uint32_t of = rays.point[k];
      rays.point[k] = by.point[of];
      for (auto& channel : rays.carried) channel[k] *= by.weight[of];
    }
    counts.rejected_samples += rays.rejected;
    trace(batch, light, rays, sums, counts);
  }
}

// Computes the light's unshadowed contribution to each point.
void SampledLights::shade(const Gathered& batch, std::uint32_t light, ShadowRayBatch& rays) {
  const PreparedLight& prepared = *lights_[light].light;
  if (taken_[light] == 0) {
    rays.count = rays.rejected = 0;
  } else if (sends_rays(light)) {
    if (prepared.extended()) places_->on_light(light, on_light_);
    shade_batch(batch.points, lights_[light], on_light_, arcs(light), rays);
  } else {
    places_->on_light(light, on_light_);
    shade_unshadowed(batch.points, lights_[light], on_light_, rays);
  }
}

// Traces a sample of each point's lobe for highlights. All lights share the same sample, which hits
// few of them.
void SampledLights::trace_lobes(const Gathered& batch, RadianceSums sums,
                                RenderStatistics& counts) {
  const ShadingPoints& points = batch.points;
  if (!any_glossy(points)) return;
  places_->on_light(number_of(SampleStream::highlights), on_light_);
  choose_lobes(points, on_light_, lobe_);
  ShadowRayBatch& rays = work_->rays;
  for (std::uint32_t light = 0; light < lights_.size(); ++light) {
    if (taken_[light] == 0 || wide_.holds(light)) continue;
    shade_lobe(points, lights_[light], lobe_, arcs(light), rays);
    counts.rejected_samples += rays.rejected;
    trace(batch, light, rays, sums, counts);
  }
}

// Adds the unoccluded contributions.
void SampledLights::trace(const Gathered& batch, std::uint32_t light, const ShadowRayBatch& rays,
                          RadianceSums sums, RenderStatistics& counts) {
  if (rays.count + rays.rejected == 0) return;
  shares_.assign(ShadingPoints::size, glm::vec3(1.0f));
  if (sends_rays(light)) {
    counts.count_shadow_ray(light, rays.count + rays.rejected);
    trace_shadows(rays, lights_[light].light->own_part);
  }
  for (std::size_t i = 0; i < rays.count; ++i) {
    const glm::vec3 carried(rays.carried[0][i], rays.carried[1][i], rays.carried[2][i]);
    sums.add(batch.targets[rays.point[i]], glm::dvec3(shares_[i] * carried));
  }
}

void SampledLights::trace_shadows(const ShadowRayBatch& rays, std::int32_t own_part) {
  if (rays.count == 0) return;
  const auto arrays = [](const auto& of) {
    return std::array<const float*, 3>{of[0].data(), of[1].data(), of[2].data()};
  };
  rays_->transmittance(
      RayArrays{rays.count, arrays(rays.origin), arrays(rays.direction), rays.t_far.data()},
      std::span(shares_).first(rays.count), own_part);
}

void SampledLights::trace_pending(RadianceSums sums) {
  // Sort rays by light, for coherence and because each light's own part is ignored.
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
      sums.add(pending_[i].target, glm::dvec3(shares_[i - first] * pending_[i].carried));
    first = end;
  }
  pending_.clear();
}

}  // namespace asos
