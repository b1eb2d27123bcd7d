#include "renderer/shadows/sampled_shadow.h"

#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/sampling/sequential_mean.h"
#include "renderer/shadows/patch_points.h"
#include "renderer/shadows/shadow.h"
#include "renderer/shadows/shadow_context.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace asos {
namespace {

constexpr std::uint32_t most_at_a_time = ShadingPoints::size;

// Returns the light's constants, with its power scaled to a maximum of 1, so that sums are safe.
LightConstants constants_of(const PreparedLight& light) {
  LightConstants constants(light);
  constants.power /= largest(constants.power);
  return constants;
}

}  // namespace

// Estimates the visibility by rays from the whole patch, in rounds until the mean has the accuracy
// that the leaf's weight needs.
Estimate sampled_shadow(const ShadowContext& block, const ShadowQuery& query,
                        RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  const ErrorBudget& error_budget = block.rules.error_budget;
  const Leaf& leaf = query.leaf;
  // Find the number of rays for the leaf, and the target error.
  const double intensity = query.intensity();
  const double worth = error_budget.samples(leaf.weight, intensity);
  const auto most_rays = std::bit_floor(static_cast<std::uint32_t>(
      std::min(error_budget.most_samples(leaf.weight), static_cast<double>(1u << 20))));
  const bool few = query.takes_rays(error_budget, LeafCosts::light_view);
  const double first_rays =
      few ? ShadowTuning::rays_for_one * worth : ShadowTuning::first_rays * leaf.weight;
  const std::uint32_t first_round = std::min(
      most_rays,
      std::bit_ceil(std::max(ShadowTuning::least_rays, static_cast<std::uint32_t>(first_rays))));
  // So few rays are never stopped early, since stopping when they agree would be biased towards the
  // majority.
  const std::uint32_t most = few ? first_round : most_rays;
  const LightConstants constants = constants_of(light);
  PatchPoints& patch = block.work->patch;
  SampledRays& sampled = block.work->sampled;
  patch.start(block, query);
  const SamplingGoal goal{error_budget.standard_error(leaf.weight, intensity), first_round, most,
                          false};
  SequentialMean found;
  double error = 0.0;
  std::uint32_t drawn = 0;
  for (std::uint32_t wanted = goal.least;; wanted = goal.after_next_round(wanted)) {
    // Send the round's rays, with replacements for those that miss the patch or the light. Without
    // replacements, parts that are hit reliably would have too much weight.
    while (found.count() < wanted && drawn < ShadowTuning::most_points_a_ray * wanted) {
      const std::uint32_t first = drawn;
      drawn += std::min(wanted - found.count(), most_at_a_time);
      const ShadingPoints& points = patch.look(block, query, first, drawn, counts);
      if (points.count == 0) continue;
      aim_batch(points, constants, patch.on_light(query.lit.index), patch.aimed_by(), sampled.rays);
      sampled.trace(block.scene->rays, light.own_part);
      for (std::size_t i = 0; i < sampled.rays.count; ++i)
        found.add(Visibility(sampled.transmittances[i]), static_cast<double>(sampled.weight(i)));
      counts.shadow_rays += sampled.rays.count;
    }
    // End once the mean is converged, or if too few points hit. Samples that agree by chance would
    // end it too early, biased towards the majority, so the error is at least that of two samples.
    error = std::max(found.standard_error(), 2.0 / std::max(1u, found.count()));
    if (goal.met(wanted, error) || found.count() < wanted) break;
  }
  return found.weight() > 0.0 ? Estimate{found.mean(), intensity * error}
                              : ray_visibility(block, query, counts);
}

void SampledRays::trace(const RayScene& scene, std::int32_t own_part) {
  transmittances.resize(rays.count);
  const auto arrays = [](const auto& of) {
    return std::array<const float*, 3>{of[0].data(), of[1].data(), of[2].data()};
  };
  scene.transmittance(
      RayArrays{rays.count, arrays(rays.origin), arrays(rays.direction), rays.t_far.data()},
      std::span(transmittances), own_part);
}

}  // namespace asos
