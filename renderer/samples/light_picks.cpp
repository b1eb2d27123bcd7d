#include "renderer/samples/light_picks.h"

#include <algorithm>
#include <span>

namespace asos {
namespace {

float most_carried(const ShadowRayBatch& rays, std::size_t i) {
  return std::max({rays.carried[0][i], rays.carried[1][i], rays.carried[2][i]});
}

// Puts ray i at place `at` of `to`, and what it carries times `weight`; within its own batch, that
// is a place before it or its own.
void put_ray(const ShadowRayBatch& rays, std::size_t i, ShadowRayBatch& to, std::size_t at,
             float weight) {
  for (std::size_t k = 0; k < 3; ++k) {
    to.origin[k][at] = rays.origin[k][i];
    to.direction[k][at] = rays.direction[k][i];
    to.carried[k][at] = weight * rays.carried[k][i];
  }
  to.t_far[at] = rays.t_far[i];
  to.point[at] = rays.point[i];
}

}  // namespace

void LightPicks::start(std::size_t lights) {
  lights_ = lights;
  if (rays_.size() < lights) rays_.resize(lights);
  for (std::size_t i = 0; i < lights; ++i) rays_[i].count = rays_[i].rejected = 0;
}

void LightPicks::pick(std::size_t points, const LightPlaceBatch::Fractions& at, float a_point) {
  weigh_none(points);
  for (std::size_t light = 0; light < lights_; ++light) weigh(rays_[light]);
  walk(at, a_point);
  for (std::size_t light = 0; light < lights_; ++light) keep_picked(rays_[light]);
}

// Each point's light, all together.
void LightPicks::weigh(const ShadowRayBatch& rays) {
  for (std::size_t i = 0; i < rays.count; ++i) share_[rays.point[i]] += most_carried(rays, i);
}

void LightPicks::walk(const LightPlaceBatch::Fractions& at, float a_point) {
  walked_.resize(share_.size());
  for (std::size_t p = 0; p < share_.size(); ++p) {
    share_[p] /= a_point;
    walked_[p] = static_cast<float>(at[p] >> 8) * 0x1p-24f;
  }
}

// Goes along the lights, a share a step.
void LightPicks::keep_picked(ShadowRayBatch& rays) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rays.count; ++i) {
    const std::uint32_t p = rays.point[i];
    const float carried = most_carried(rays, i);
    if (carried >= share_[p]) {
      put_ray(rays, i, rays, kept++, 1.0f);
      continue;
    }
    walked_[p] += carried / share_[p];
    if (walked_[p] < 1.0f) continue;
    walked_[p] -= 1.0f;
    put_ray(rays, i, rays, kept++, share_[p] / carried);
  }
  rays.count = kept;
}

void LightPicks::pick_one(std::size_t points, Range lights, const LightPlaceBatch::Fractions& at,
                          float share, ShadowRayBatch& kept) {
  const std::span of(rays_.data() + lights.first, lights.count);
  share_.assign(points, 0.0f);
  for (const ShadowRayBatch& rays : of)
    for (std::size_t i = 0; i < rays.count; ++i) share_[rays.point[i]] += most_carried(rays, i);
  // Walk along the rays until the point's own share of all is passed; then never again.
  walked_.resize(points);
  for (std::size_t p = 0; p < points; ++p)
    walked_[p] = static_cast<float>(at[p] >> 8) * 0x1p-24f * share_[p];
  kept.count = kept.rejected = 0;
  for (const ShadowRayBatch& rays : of) {
    for (std::size_t i = 0; i < rays.count; ++i) {
      const std::uint32_t p = rays.point[i];
      const float carried = most_carried(rays, i);
      if (walked_[p] < 0.0f) continue;
      walked_[p] -= carried;
      if (walked_[p] < 0.0f) put_ray(rays, i, kept, kept.count++, share * share_[p] / carried);
    }
  }
}

}  // namespace asos
