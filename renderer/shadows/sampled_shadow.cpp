#include "renderer/shadows/sampled_shadow.h"

#include "renderer/geometry/largest.h"
#include "renderer/pyray/prices.h"
#include "renderer/shadows/lit_patch.h"
#include "renderer/shadows/shadow.h"
#include "renderer/shadows/shadow_context.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// Rays of the first round, for each further one of which their number doubles, and at most.
constexpr double first_rays_a_root = 16.0;
constexpr std::uint32_t least_rays = 8;
// Rays of a part that deserves few of them, and how many times more than it deserves it takes:
// where they start and what they are aimed at costs more than they do, so that they cost next to
// nothing.
constexpr std::uint32_t fewest_rays = 4;
constexpr double rays_for_one = 4.0;
// For each finest cell at most: to all of a light, and to a point.
constexpr double rays_to_all = 8.0;
constexpr double rays_to_one = 4.0;
// Points drawn at most for each ray that is asked for: where parts and lights fill less of their
// boxes, what was found stands.
constexpr std::uint32_t most_points_a_ray = 16;
constexpr std::uint32_t most_at_a_time = LitBatch::size;

/// The mean visibility of weighted samples, and how well it is known: by quarters of the samples,
/// each of which is as well distributed as its size allows.
struct WeighedVisibility {
  Visibility mean{0.0};
  double standard_error = std::numeric_limits<double>::infinity();

  static WeighedVisibility of(std::span<const double> weights,
                              std::span<const glm::vec3> transmittances) {
    // Sum up the quarters.
    std::array<double, 4> all{};
    std::array<Visibility, 4> lit{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const std::size_t quarter = 4 * i / weights.size();
      all[quarter] += weights[i];
      lit[quarter] += weights[i] * Visibility(transmittances[i]);
    }
    const double whole = all[0] + all[1] + all[2] + all[3];
    if (!(whole > 0.0)) return {};
    WeighedVisibility part;
    part.mean = (lit[0] + lit[1] + lit[2] + lit[3]) / whole;
    // Their scatter tells the error of the mean.
    Visibility squares(0.0);
    for (std::size_t q = 0; q < 4; ++q) {
      const Visibility off = lit[q] - part.mean * all[q];
      squares += off * off;
    }
    // That all samples agree does not prove that all of the light does: one more might not. To end
    // sooner favours what most of them saw.
    part.standard_error =
        std::max(std::sqrt(4.0 / 3.0 * std::max({squares.x, squares.y, squares.z})) / whole,
                 1.0 / static_cast<double>(weights.size()));
    return part;
  }
};

// The light, with as much power as is safe to sum up.
LightConstants constants_of(const PreparedLight& light) {
  LightConstants constants(light);
  constants.power /= largest(constants.power);
  return constants;
}

}  // namespace

// Rays from all over the patch, in rounds until their mean is known as well as the leaf's weight
// deserves.
Visibility sampled_shadow(const ShadowContext& block, const ShadowQuery& query,
                          RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  const Budget budget = block.rules.budget.for_samples();
  const LeafContext& leaf = query.leaf;
  // Find how many rays the leaf is worth, and the error to reach.
  const double intensity = query.intensity();
  const bool few = budget.rays_suffice(leaf.weight, intensity, Prices::light_window);
  const double first_rays =
      few ? rays_for_one * budget.rays(leaf.weight, intensity) : first_rays_a_root * leaf.weight;
  const std::uint32_t first_round = std::bit_ceil(
      std::max(few ? fewest_rays : least_rays, static_cast<std::uint32_t>(first_rays)));
  // So few all count: to end once they agree would favour what most of them see.
  const double rays_a_finest_cell = light.extended() ? rays_to_all : rays_to_one;
  const std::uint32_t most =
      few ? first_round : budget.samples(leaf.weight, rays_a_finest_cell, first_round);
  const double error = budget.standard_error(leaf.weight, intensity);
  const LightConstants constants = constants_of(light);
  LitPatch& patch = block.work->patch;
  SampledRays& sampled = block.work->sampled;
  patch.start(block, query);
  sampled.clear();
  WeighedVisibility found;
  std::uint32_t drawn = 0;
  for (std::uint32_t wanted = first_round; wanted <= most; wanted *= 2) {
    // Send the round's rays, and others instead of those that miss the patch or the light: a mean
    // over those of a fixed number of points that hit would favour the parts that they hit surely.
    while (sampled.count() < wanted && drawn < most_points_a_ray * wanted) {
      const std::uint32_t first = drawn;
      drawn += std::min(static_cast<std::uint32_t>(wanted - sampled.count()), most_at_a_time);
      const LitBatch& points = patch.look(block, query, first, drawn, counts);
      if (points.count == 0) continue;
      aim_batch(points, constants, patch.on_light(query.lit.index), patch.aimed_by(), sampled.rays);
      sampled.trace(block.scene->rays, light.own_part);
      counts.shadow_rays += sampled.rays.count;
    }
    // End once the mean is known well enough, or too few points hit.
    found = WeighedVisibility::of(sampled.weights, sampled.transmittances);
    if (found.standard_error <= error || sampled.count() < wanted) break;
  }
  return sampled.weights.empty() ? ray_visibility(block, query, counts) : found.mean;
}

void SampledRays::clear() {
  weights.clear();
  transmittances.clear();
}

void SampledRays::trace(const RayScene& scene, std::int32_t own_part) {
  const std::size_t before = weights.size();
  const auto& carried = rays.carried[0];
  weights.insert(weights.end(), carried.begin(), carried.begin() + rays.count);
  transmittances.resize(weights.size());
  const auto arrays = [](const auto& of) {
    return std::array<const float*, 3>{of[0].data(), of[1].data(), of[2].data()};
  };
  scene.transmittance(
      RayArrays{rays.count, arrays(rays.origin), arrays(rays.direction), rays.t_far.data()},
      std::span(transmittances).subspan(before), own_part);
}

}  // namespace asos
