#include "renderer/samples/wide_lights.h"

#include "renderer/geometry/largest.h"
#include "renderer/sampling/random.h"
#include "renderer/shading/reflected_light.h"

#include <algorithm>
#include <numbers>

namespace asos {
namespace {

// Returns whether most points have highlights brighter than their diffuse reflection.
bool most_shine(const ShadingPoints& points) {
  constexpr float broad = least_broad_roughness * least_broad_roughness;
  std::size_t shining = 0;
  for (std::size_t i = 0; i < points.count; ++i) {
    const float alpha = points.alpha[i];
    const float peak =
        largest(points.f0.at(i)) / (4.0f * std::numbers::pi_v<float> * alpha * alpha);
    shining += alpha < broad && peak > largest(points.diffuse.at(i));
  }
  return 2 * shining > points.count;
}

// Returns whether the light is wider than the lobe at the batch's central point.
bool wider_than_lobe(const PreparedLight& light, const ShadingPoints& points) {
  if (!light.extended() || light.rule != LightRule::physical) return false;
  const std::size_t i = points.count / 2;
  const glm::vec3 mirrored = glm::reflect(-points.to_viewer.at(i), points.normal.at(i));
  const Highlight shown =
      highlight_of(light, glm::dvec3(points.position.at(i)), glm::dvec3(mirrored));
  return shown.half_angle_tangent > points.alpha[i];
}

// Returns a 32-bit fraction that is distributed evenly over samples and lights.
std::uint32_t chance(const SampleIndex& sample, std::uint32_t light) {
  const auto half = [](std::uint32_t high, std::uint32_t low) {
    return static_cast<std::uint64_t>(high) << 32 | low;
  };
  const std::uint64_t pixel =
      half(static_cast<std::uint32_t>(sample.x), static_cast<std::uint32_t>(sample.y));
  const std::uint64_t which = half(light, static_cast<std::uint32_t>(sample.index));
  return static_cast<std::uint32_t>(mix_bits(mix_bits(pixel) ^ which) >> 32);
}

float most_carried(const ShadowRayBatch& rays, std::size_t i) {
  return std::max({rays.carried[0][i], rays.carried[1][i], rays.carried[2][i]});
}

// Appends ray i to `to`, with its contribution multiplied by `weight`.
void append_ray(const ShadowRayBatch& rays, std::size_t i, float weight, ShadowRayBatch& to) {
  const std::size_t at = to.count++;
  for (std::size_t k = 0; k < 3; ++k) {
    to.origin[k][at] = rays.origin[k][i];
    to.direction[k][at] = rays.direction[k][i];
    to.carried[k][at] = weight * rays.carried[k][i];
  }
  to.t_far[at] = rays.t_far[i];
  to.point[at] = rays.point[i];
}

}  // namespace

void pick_one(std::size_t points, std::span<const ShadowRayBatch> rays,
              const LightPointBatch::Fractions& at, float share, std::vector<float>& walked,
              ShadowRayBatch& kept) {
  walked.assign(2 * points, 0.0f);
  const std::span<float> all = std::span(walked).first(points),
                         left = std::span(walked).last(points);
  for (const ShadowRayBatch& of : rays)
    for (std::size_t i = 0; i < of.count; ++i) all[of.point[i]] += most_carried(of, i);
  // Walk along the rays until the point's random part of the total is passed; each point keeps only
  // that ray.
  for (std::size_t p = 0; p < points; ++p)
    left[p] = static_cast<float>(at[p] >> 8) * 0x1p-24f * all[p];
  kept.count = kept.rejected = 0;
  for (const ShadowRayBatch& of : rays) {
    for (std::size_t i = 0; i < of.count; ++i) {
      const std::uint32_t p = of.point[i];
      const float carried = most_carried(of, i);
      if (left[p] < 0.0f) continue;
      left[p] -= carried;
      if (left[p] < 0.0f) append_ray(of, i, share * all[p] / carried, kept);
    }
  }
}

void WideLights::find(const ShadingPoints& points, std::span<const LightConstants> lights,
                      std::span<const std::uint8_t> asked, LightSamplePoints& places) {
  wide_.clear();
  if (asked.empty() || !most_shine(points)) return;
  for (std::size_t i = 0; i < lights.size(); ++i)
    wide_.push_back(asked[i] != 0 && wider_than_lobe(*lights[i].light, points) ? 1 : 0);
  if (std::none_of(wide_.begin(), wide_.end(), [](std::uint8_t wide) { return wide != 0; })) {
    wide_.clear();
    return;
  }
  if (!work_) work_ = ThreadLocalCache<Work>::make();
  places.on_light(number_of(SampleStream::highlights), work_->places);
  for (std::uint32_t k = 0; k < candidates; ++k)
    choose_lobes(points, part_of_places(k, points.count), work_->lobes[k]);
}

std::span<const ShadowRayBatch> WideLights::shade(const ShadingPoints& points,
                                                  std::span<const SampleIndex> samples,
                                                  std::uint32_t light,
                                                  const LightConstants& constants,
                                                  LightSamplePoints& places) {
  auto& [lobes, on_light, part, arcs, rays, picked, walked] = *work_;
  arcs.known = false;
  places.on_light(light, on_light);
  for (std::uint32_t k = 0; k < candidates; ++k) {
    shade_batch(points, constants, part_of_places(k, points.count), arcs, rays[k]);
    shade_lobe(points, constants, lobes[k], arcs, rays[candidates + k]);
  }
  for (std::size_t i = 0; i < points.count; ++i) part.u[i] = chance(samples[i], light);
  for (std::size_t half = 0; half < picked.size(); ++half) {
    const auto of = std::span(rays).subspan(half * candidates, candidates);
    pick_one(points.count, of, part.u, 1.0f / candidates, walked, picked[half]);
    for (const ShadowRayBatch& each : of) picked[half].rejected += each.rejected;
  }
  return work_->picked;
}

// Moves the places to one of `candidates` equal parts of the unit square.
const LightPointBatch& WideLights::part_of_places(std::uint32_t part, std::size_t count) {
  constexpr std::uint32_t side = 2;
  static_assert(side * side == candidates);
  const std::uint32_t u = part % side << 31, v = part / side << 31;
  for (std::size_t i = 0; i < count; ++i) {
    work_->part.u[i] = work_->places.u[i] >> 1 | u;
    work_->part.v[i] = work_->places.v[i] >> 1 | v;
  }
  return work_->part;
}

}  // namespace asos
