#include "renderer/kernels/lit_batch.h"

#include <algorithm>
#include <numbers>

namespace asos {
namespace {

/// Calls `one` for each field of a number a point and `three` for each of a vector: for those of
/// points whose lobes turn only where any does.
template <typename One, typename Three>
void for_each_field(bool any_turns, One one, Three three) {
  for (const auto field :
       {&LitBatch::position, &LitBatch::geometric, &LitBatch::normal, &LitBatch::to_viewer,
        &LitBatch::diffuse, &LitBatch::f0, &LitBatch::f90_less_f0})
    three(field);
  for (const auto field :
       {&LitBatch::clear_height, &LitBatch::to_edge, &LitBatch::n_dot_v, &LitBatch::falloff,
        &LitBatch::alpha, &LitBatch::shows_lights, &LitBatch::turns})
    one(field);
  if (!any_turns) return;
  for (const auto field : {&LitBatch::stretch, &LitBatch::patch_right, &LitBatch::patch_down,
                           &LitBatch::spread_right, &LitBatch::spread_down})
    three(field);
  for (const auto field :
       {&LitBatch::sheen, &LitBatch::viewer_nearness, &LitBatch::spread_variance})
    one(field);
}

}  // namespace

void LitBatch::add(const LitPoint& lit, glm::vec3 weight) {
  const std::size_t i = count++;
  const SurfacePoint& point = lit.view.point;
  const ViewedMaterial& material = lit.material;
  position.set(i, point.position);
  geometric.set(i, point.geometric_normal);
  normal.set(i, point.shading_normal);
  to_viewer.set(i, lit.view.to_viewer);
  clear_height[i] = asos::clear_height(point);
  to_edge[i] = point.to_edge;
  n_dot_v[i] = lit.view.n_dot_v;

  const glm::vec3 share = weight * lit.share;
  diffuse.set(i, share * material.diffuse * std::numbers::inv_pi_v<float>);
  falloff[i] = material.falloff;
  f0.set(i, share * material.f0);
  f90_less_f0.set(i, share * (material.f90 - material.f0));
  const float roughness = std::clamp(material.roughness, roughness_floor, 1.0f);
  alpha[i] = roughness * roughness;
  set_mirrored(i, lit.mirrored);

  const Patch& patch = lit.view.patch;
  const bool is_point = patch.right == glm::vec3(0.0f) && patch.down == glm::vec3(0.0f);
  sheen[i] = material.sheen;
  const bool plain_lobe = !(material.sheen > 0.0f) && material.stretch.none();
  turns[i] = is_point && point.spread.flat() && plain_lobe ? 0.0f : 1.0f;
  if (turns[i] == 0.0f) return;
  stretch.set(i, material.stretch.along);
  viewer_nearness[i] = 1.0f / lit.view.distance;
  patch_right.set(i, patch.right);
  patch_down.set(i, patch.down);
  spread_right.set(i, point.spread.right);
  spread_down.set(i, point.spread.down);
  spread_variance[i] = point.spread.variance;
}

void LitBatch::repeat_first(std::size_t times) {
  count = times;
  for_each_field(
      turns[0] != 0.0f,
      [&](Floats LitBatch::*field) {
        Floats& values = this->*field;
        std::fill_n(values.begin() + 1, times - 1, values[0]);
      },
      [&](Vectors LitBatch::*field) {
        Vectors& values = this->*field;
        for (Floats* axis : {&values.x, &values.y, &values.z})
          std::fill_n(axis->begin() + 1, times - 1, (*axis)[0]);
      });
}

void LitBatch::gather(const LitBatch& from, std::span<const std::uint32_t> indices) {
  count = indices.size();
  const bool any_turns = std::any_of(indices.begin(), indices.end(),
                                     [&](std::uint32_t i) { return from.turns[i] != 0.0f; });
  for_each_field(
      any_turns,
      [&](Floats LitBatch::*field) {
        const Floats& values = from.*field;
        Floats& taken = this->*field;
        for (std::size_t k = 0; k < indices.size(); ++k) taken[k] = values[indices[k]];
      },
      [&](Vectors LitBatch::*field) {
        const Vectors& values = from.*field;
        Vectors& taken = this->*field;
        for (std::size_t k = 0; k < indices.size(); ++k) taken.set(k, values.at(indices[k]));
      });
}

}  // namespace asos
