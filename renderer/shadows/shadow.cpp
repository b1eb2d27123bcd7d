#include "renderer/shadows/shadow.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/shadow_ray.h"
#include "renderer/shadows/area_shadow.h"
#include "renderer/shadows/hard_shadow.h"
#include "renderer/shadows/linear_shadow.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asos {
namespace {

Box box_of(const ShadowPatch& patch) {
  Box box;
  for (const glm::dvec3& corner : patch.corners) box.grow(glm::vec3(corner));
  return box;
}

// Returns the visibility if it is known for the whole passage. A passage without boundaries does
// not exclude objects that touch the light itself.
std::optional<Estimate> visibility_of(const KnownVisibility& known, const PreparedLight& light) {
  if (known.passage == KnownVisibility::Passage::open || !light.intersections.empty())
    return std::nullopt;
  return Estimate::exact(Visibility(known.passage == KnownVisibility::Passage::lit ? 1.0 : 0.0));
}

// Returns the visibility that the block knows for the passage to a light, or else that of one ray.
Estimate known_visibility(const ShadowContext& block, const Illumination& lit, const Leaf& leaf,
                          RenderStatistics& counts) {
  Box around;
  around.grow(lit.point.lit_position());
  const KnownVisibility known =
      block.groups->ask(lit.light, lit.index, lit.point, around, counts.shadow_rays);
  if (const auto visibility = visibility_of(known, lit.light)) return *visibility;
  return ray_visibility(block, {lit, leaf, {}}, counts);
}

Estimate leaf_visibility(const ShadowContext& block, const Illumination& lit, const Leaf& leaf,
                         RenderStatistics& counts) {
  ShadowQuery query{lit, leaf, {}};
  // A marginal leaf is worth one ray.
  if (leaf.region.marginal) return ray_visibility(block, query, counts);

  // Use the block's data on the passage to the light.
  const auto patch = has_patch(block, lit)
                         ? patch_of(block, lit.point, leaf.region, leaf.region.square)
                         : std::nullopt;
  Box around;
  if (patch) {
    around = box_of(*patch);
  } else {
    around.grow(lit.point.lit_position());
  }
  const KnownVisibility known =
      block.groups->ask(lit.light, lit.index, lit.point, around, counts.shadow_rays);
  if (const auto visibility = visibility_of(known, lit.light)) return *visibility;

  // Trace, by the kind of light.
  query.found = own_part_ignored(block.scene->world, lit.light);
  query.found.cut = known.cut;
  if (lit.light.traits().line) return linear_shadow(block, query, counts);
  if (lit.light.extended()) return area_shadow(block, query, counts);
  return patch ? hard_shadow(block, query, *patch, counts) : ray_visibility(block, query, counts);
}

// Returns the visibility for a leaf in an evenly lit patch. An extended light's visibility from the
// patch's centre holds for the whole patch. For a point light that is true if the shadow has no
// boundaries, so the patch is either fully lit or fully in shadow.
Estimate even_visibility(const ShadowContext& block, const Illumination& lit, const Leaf& leaf,
                         RenderStatistics& counts) {
  UniformShadowPatch& even = *leaf.even;
  Visibility& visibility = even.visibilities[lit.index];
  const auto holds_for_all = [&] {
    return lit.light.extended() || visibility == Visibility(0.0) || visibility == Visibility(1.0);
  };
  if (visibility.x < 0.0) {
    const glm::vec3 there = unshadowed_irradiance(lit.light, receiver_at(even.whole.point));
    // The light is below the horizon of the patch's centre, but not of this leaf.
    if (there == glm::vec3(0.0f)) return leaf_visibility(block, lit, leaf, counts);
    Leaf middle = even.whole;
    middle.weight = std::pow(middle.region.square.side / middle.root_side, 2.0f);
    middle.at = leaf.at;
    middle.seed = leaf.seed;
    middle.observed = leaf.observed;
    // The lobe is that of the leaf, which is nearby.
    const Illumination of_middle{lit.light,     lit.index, middle.point, there,
                                 lit.reflected, lit.layer, lit.lit,      lit.highlight};
    visibility = leaf_visibility(block, of_middle, middle, counts).value;
  }
  return holds_for_all() ? Estimate::exact(visibility) : leaf_visibility(block, lit, leaf, counts);
}

}  // namespace

CountForLight::CountForLight(RenderStatistics& counts, std::uint32_t light)
    : counts_(counts),
      light_(light),
      rays_before_(counts.shadow_rays),
      pyrays_before_(counts.shadow_pyrays),
      light_before_(counts.of_light(light)) {}

CountForLight::~CountForLight() {
  const LightStatistics now = {
      light_before_.shadow_rays + counts_.shadow_rays - rays_before_,
      light_before_.shadow_pyrays + counts_.shadow_pyrays - pyrays_before_};
  if (now == light_before_) return;
  if (light_ >= counts_.lights.size()) counts_.lights.resize(light_ + std::size_t{1});
  counts_.lights[light_] = now;
}

Estimate light_visibility(const ShadowContext& block, const Illumination& lit, const Leaf& leaf,
                          RenderStatistics& counts) {
  const std::uint64_t before = counts.shadow_rays;
  // One ray is enough for lights so weak that all of them together stay below EPS. Without any ray
  // they would shine through walls.
  const glm::vec3 all = lit.reflected * lit.unshadowed;
  const double weakest = block.rules.error_budget.eps / static_cast<double>(block.lights);
  const bool weak = !(static_cast<double>(largest(all)) > weakest);
  const bool even = leaf.even && lit.layer == 0;
  Estimate seen = weak   ? known_visibility(block, lit, leaf, counts)
                  : even ? even_visibility(block, lit, leaf, counts)
                         : leaf_visibility(block, lit, leaf, counts);
  seen.cost = static_cast<double>(counts.shadow_rays - before);
  return seen;
}

Estimate ray_visibility(const ShadowContext& block, const ShadowQuery& query,
                        RenderStatistics& counts) {
  // Skip points of the light below the horizon, since they say nothing about occlusion.
  constexpr int most_points = 32;
  const Illumination& lit = query.lit;
  const Receiver receiver = receiver_at(lit.point);
  std::uint64_t seed = query.leaf.seed + 0x9e3779b97f4a7c15ULL * (lit.index + 1);
  for (int i = 0; i < most_points; ++i, seed += 0xd1342543de82ef95ULL) {
    const glm::dvec2 at = unit_pair_of(seed);
    const LightSample sample = sample_light(lit.light, receiver, at.x, at.y);
    if (sample.irradiance == glm::vec3(0.0f)) continue;
    ++counts.shadow_rays;
    const glm::vec3 passed =
        block.scene->rays.transmittance(shadow_ray(lit.point, sample), lit.light.own_part);
    return {Visibility(passed), query.intensity(), 1.0};
  }
  return Estimate::exact(Visibility(1.0));
}

}  // namespace asos
