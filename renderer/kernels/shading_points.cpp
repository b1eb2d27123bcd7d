#include "renderer/kernels/shading_points.h"

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
  work(&ShadingPoints::position), work(&ShadingPoints::geometric), work(&ShadingPoints::normal);
  work(&ShadingPoints::clear_height), work(&ShadingPoints::to_edge), work(&ShadingPoints::turns);
  if (last == Told::place) return;
  for (const auto field : {&ShadingPoints::to_viewer, &ShadingPoints::diffuse, &ShadingPoints::f0,
                           &ShadingPoints::f90_less_f0})
    work(field);
  for (const auto field : {&ShadingPoints::n_dot_v, &ShadingPoints::falloff, &ShadingPoints::alpha,
                           &ShadingPoints::shows_lights, &ShadingPoints::sheen})
    work(field);
  if (last == Told::material) return;
  for (const auto field :
       {&ShadingPoints::stretch, &ShadingPoints::patch_right, &ShadingPoints::patch_down,
        &ShadingPoints::spread_right, &ShadingPoints::spread_down})
    work(field);
  for (const auto field : {&ShadingPoints::viewer_nearness, &ShadingPoints::spread_variance})
    work(field);
}

void repeat(ShadingPoints::Floats& values, std::size_t times) {
  std::fill_n(values.begin() + 1, times - 1, values[0]);
}
void repeat(ShadingPoints::Vectors& values, std::size_t times) {
  for (ShadingPoints::Floats* axis : {&values.x, &values.y, &values.z}) repeat(*axis, times);
}

void take(const ShadingPoints::Floats& from, std::span<const std::uint32_t> indices,
          ShadingPoints::Floats& taken) {
  for (std::size_t k = 0; k < indices.size(); ++k) taken[k] = from[indices[k]];
}
void take(const ShadingPoints::Vectors& from, std::span<const std::uint32_t> indices,
          ShadingPoints::Vectors& taken) {
  for (std::size_t k = 0; k < indices.size(); ++k) taken.set(k, from.at(indices[k]));
}

}  // namespace

void ShadingPoints::add(const LightingQuery& lit, glm::vec3 weight) {
  const std::size_t i = count;
  const SurfacePoint& point = lit.view.point;
  const ViewedMaterial& material = lit.material;
  add(point);
  to_viewer.set(i, lit.view.to_viewer);
  n_dot_v[i] = lit.view.n_dot_v;

  set_material(i, material, weight * lit.share);
  set_mirrored(i, lit.mirrored);

  const Patch& patch = lit.view.patch;
  const bool is_point = patch.right == glm::vec3(0.0f) && patch.down == glm::vec3(0.0f);
  const bool plain_lobe = !material.lobe.is_sheen() && material.lobe.stretch.none();
  turns[i] = is_point && point.spread.flat() && plain_lobe ? 0.0f : 1.0f;
  if (turns[i] == 0.0f) return;
  viewer_nearness[i] = 1.0f / lit.view.distance;
  patch_right.set(i, patch.right);
  patch_down.set(i, patch.down);
  spread_right.set(i, point.spread.right);
  spread_down.set(i, point.spread.down);
  spread_variance[i] = point.spread.variance;
}

void ShadingPoints::set_material(std::size_t i, const ViewedMaterial& material, glm::vec3 share) {
  diffuse.set(i, share * material.diffuse * std::numbers::inv_pi_v<float>);
  falloff[i] = material.falloff;
  const Lobe& lobe = material.lobe;
  f0.set(i, share * lobe.f0);
  f90_less_f0.set(i, share * (lobe.f90 - lobe.f0));
  alpha[i] = lobe.alpha();
  sheen[i] = lobe.sheen;
  stretch.set(i, lobe.stretch.along);
}

void ShadingPoints::add(const SurfacePoint& point) {
  const std::size_t i = count++;
  position.set(i, point.lit_position());
  geometric.set(i, point.horizon());
  normal.set(i, point.shading_normal);
  clear_height[i] = asos::clear_height(point);
  to_edge[i] = point.to_edge;
  turns[i] = 0.0f;
}

void ShadingPoints::repeat_first(std::size_t times, bool with_material) {
  count = times;
  const Told last = !with_material     ? Told::place
                    : turns[0] != 0.0f ? Told::turning_lobe
                                       : Told::material;
  for_each_field(last, [&](auto field) { repeat(this->*field, times); });
}

void ShadingPoints::gather(const ShadingPoints& from, std::span<const std::uint32_t> indices) {
  count = indices.size();
  const bool any_turns = std::any_of(indices.begin(), indices.end(),
                                     [&](std::uint32_t i) { return from.turns[i] != 0.0f; });
  for_each_field(any_turns ? Told::turning_lobe : Told::material,
                 [&](auto field) { take(from.*field, indices, this->*field); });
}

}  // namespace asos
