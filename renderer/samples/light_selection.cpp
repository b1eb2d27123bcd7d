#include "renderer/samples/light_selection.h"

#include <algorithm>

namespace asos {

void LightSelection::pick(const LightTable& lights, const ShadingPoints& points,
                          const LightPointBatch::Fractions& at, float a_point) {
  constexpr float least = 1e-30f;
  worth_.resize(lights.padded_size());
  picks_.clear();
  for (std::uint32_t p = 0; p < points.count; ++p) {
    const float all = weigh_lights(lights, points, p, worth_);
    if (all > least)
      pick_for(p, share_of_ray(all, a_point), static_cast<float>(at[p] >> 8) * 0x1p-24f);
  }
  sort_by_light(lights.size());
}

// Returns the worth that one ray represents. Lights above it have one ray each, and the remaining
// rays are divided by the worth of the remaining lights. An overestimated highlight of one light
// thus does not reduce the rays of the others.
float LightSelection::share_of_ray(float all, float a_point) const {
  constexpr int rounds = 2;
  float share = all / a_point;
  for (int round = 0; round < rounds; ++round) {
    float rest = 0.0f, taken = 0.0f;
    for (const float worth : worth_) {
      rest += worth < share ? worth : 0.0f;
      taken += worth < share ? 0.0f : 1.0f;
    }
    if (taken == 0.0f || rest == 0.0f) break;
    share = std::min(share, rest / std::max(1.0f, a_point - taken));
  }
  return share;
}

// Walks along the lights and picks one per `share`. `walked` is the fraction of a share since the
// last pick.
void LightSelection::pick_for(std::uint32_t point, float share, float walked) {
  const float per_share = 1.0f / share;
  for (std::uint32_t light = 0; light < worth_.size(); ++light) {
    if (worth_[light] >= share) {
      picks_.push_back({light, point, 1.0f});
      continue;
    }
    const float probability = worth_[light] * per_share;
    walked += probability;
    if (walked < 1.0f) continue;
    walked -= 1.0f;
    picks_.push_back({light, point, 1.0f / probability});
  }
}

void LightSelection::sort_by_light(std::size_t lights) {
  first_.assign(lights + 1, 0);
  for (const Pick& pick : picks_) ++first_[pick.light + 1];
  for (std::size_t i = 0; i < lights; ++i) first_[i + 1] += first_[i];
  point_.resize(picks_.size());
  weight_.resize(picks_.size());
  for (const Pick& pick : picks_) {
    const std::size_t at = first_[pick.light]++;
    point_[at] = pick.point;
    weight_[at] = pick.weight;
  }
  // Each entry is now where the next light begins.
  first_.insert(first_.begin(), 0);
}

}  // namespace asos
