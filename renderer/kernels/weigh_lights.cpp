#include "renderer/kernels/weigh_lights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/weigh_lights.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/weight_lanes.h"
#include "renderer/shading/lobe.h"

#include <algorithm>
#include <hwy/highway.h>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

/// Returns alpha^2 of the point's lobe, or of an isotropic lobe about as wide as the patch's lobe.
float alpha2_of(const ShadingPoints& points, std::size_t i) {
  const float alpha = points.alpha[i];
  if (points.turns[i] == 0.0f) return alpha * alpha;
  if (points.sheen[i] > 0.0f) return 1.0f;
  const auto square_of = [&](const ShadingPoints::Vectors& v) {
    return glm::dot(v.at(i), v.at(i));
  };
  const float by_normals =
      (square_of(points.spread_right) + square_of(points.spread_down)) / 24.0f +
      points.spread_variance[i];
  const float by_stretch = 0.5f * square_of(points.stretch);
  return alpha * alpha + std::min(by_normals, PatchLobe::most_added) + by_stretch;
}

void weigh(const LightTable& lights, const ShadingPoints& points, std::size_t i, float* weights) {
  PointLanes at;
  at.position = all_lanes(points.position.at(i));
  at.geometric = all_lanes(points.geometric.at(i));
  at.normal = all_lanes(points.normal.at(i));
  at.to_viewer = all_lanes(points.to_viewer.at(i));
  at.diffuse = all_lanes(points.diffuse.at(i));
  at.f0 = all_lanes(points.f0.at(i));
  at.f90_less_f0 = all_lanes(points.f90_less_f0.at(i));
  at.falloff = all_lanes(points.falloff[i]);
  at.n_dot_v = all_lanes(points.n_dot_v[i]);
  at.alpha2 = all_lanes(std::min(1.0f, alpha2_of(points, i)));
  at.shows_lights = all_lanes(points.shows_lights[i]);
  set_tangents(at);
  const glm::vec3 most = points.f0.at(i) + points.f90_less_f0.at(i);
  const FloatTag d;
  const auto shines = hn::FirstN(d, most == glm::vec3(0.0f) ? 0 : hn::Lanes(d));
  for (std::size_t k = 0; k < lights.padded_size(); k += hn::Lanes(d))
    hn::StoreU(weight(LightLanes{lights, k}, at, shines), d, weights + k);
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(weigh);

float weigh_lights(const LightTable& lights, const ShadingPoints& points, std::size_t i,
                   std::span<float> weights) {
  HWY_DYNAMIC_DISPATCH(weigh)(lights, points, i, weights.data());
  // Add up sixteen partial sums, independent of the number of lanes.
  std::array<float, LightTable::step> sums{};
  for (std::size_t k = 0; k < lights.padded_size(); k += sums.size())
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += weights[k + j];
  return std::accumulate(sums.begin(), sums.end(), 0.0f);
}

}  // namespace asos
#endif
