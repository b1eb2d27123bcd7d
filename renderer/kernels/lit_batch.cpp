#include "renderer/kernels/lit_batch.h"

#include <algorithm>
#include <numbers>

namespace asos {
namespace {

/// Groups of a point's fields, in ascending order.
enum class Told { place, material, turning_lobe };

/// Calls one function for each scalar field of a point and one for each vector field, up to group
/// `last`.
template <typename Work>
void for_each_field(Told last, Work work) {
  work(&LitBatch::position), work(&LitBatch::geometric), work(&LitBatch::normal);
  work(&LitBatch::clear_height), work(&LitBatch::to_edge), work(&LitBatch::turns);
  if (last == Told::place) return;
  for (const auto field :
       {&LitBatch::to_viewer, &LitBatch::diffuse, &LitBatch::f0, &LitBatch::f90_less_f0})
    work(field);
  for (const auto field : {&LitBatch::n_dot_v, &LitBatch::falloff, &LitBatch::alpha,
                           &LitBatch::shows_lights, &LitBatch::sheen})
    work(field);
  if (last == Told::material) return;
  for (const auto field : {&LitBatch::stretch, &LitBatch::patch_right, &LitBatch::patch_down,
                           &LitBatch::spread_right, &LitBatch::spread_down})
    work(field);
  for (const auto field : {&LitBatch::viewer_nearness, &LitBatch::spread_variance}) work(field);
}

void repeat(LitBatch::Floats& values, std::size_t times) {
  std::fill_n(values.begin() + 1, times - 1, values[0]);
}
void repeat(LitBatch::Vectors& values, std::size_t times) {
  for (LitBatch::Floats* axis : {&values.x, &values.y, &values.z}) repeat(*axis, times);
}

void take(const LitBatch::Floats& from, std::span<const std::uint32_t> indices,
          LitBatch::Floats& taken) {
  for (std::size_t k = 0; k < indices.size(); ++k) taken[k] = from[indices[k]];
}
void take(const LitBatch::Vectors& from, std::span<const std::uint32_t> indices,
          LitBatch::Vectors& taken) {
  for (std::size_t k = 0; k < indices.size(); ++k) taken.set(k, from.at(indices[k]));
}

}  // namespace

void LitBatch::add(const LitPoint& lit, glm::vec3 weight) {
  const std::size_t i = count;
  const SurfacePoint& point = lit.view.point;
  const ViewedMaterial& material = lit.material;
  add(point);
  to_viewer.set(i, lit.view.to_viewer);
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

void LitBatch::add(const SurfacePoint& point) {
  const std::size_t i = count++;
  position.set(i, point.lit_position());
  geometric.set(i, point.horizon());
  normal.set(i, point.shading_normal);
  clear_height[i] = asos::clear_height(point);
  to_edge[i] = point.to_edge;
  turns[i] = 0.0f;
}

void LitBatch::repeat_first(std::size_t times, bool with_material) {
  count = times;
  const Told last = !with_material     ? Told::place
                    : turns[0] != 0.0f ? Told::turning_lobe
                                       : Told::material;
  for_each_field(last, [&](auto field) { repeat(this->*field, times); });
}

void LitBatch::gather(const LitBatch& from, std::span<const std::uint32_t> indices) {
  count = indices.size();
  const bool any_turns = std::any_of(indices.begin(), indices.end(),
                                     [&](std::uint32_t i) { return from.turns[i] != 0.0f; });
  for_each_field(any_turns ? Told::turning_lobe : Told::material,
                 [&](auto field) { take(from.*field, indices, this->*field); });
}

}  // namespace asos
