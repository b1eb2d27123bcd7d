#include "renderer/shadows/sampled_shadow.h"

#include "renderer/pyray/prices.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shadows/broad_lobe.h"
#include "renderer/shadows/shadow.h"

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

// The cosines of both ends over the squared distance, as far as they change across the window.
double weight_of(const PreparedLight& light, const Receiver& receiver, glm::dvec3 to_light) {
  const double d2 = glm::dot(to_light, to_light);
  const double here = glm::dot(receiver.normal, to_light);
  if (!(here > 0.0) || !(glm::dot(receiver.geometric, to_light) > 0.0)) return 0.0;
  const bool flat =
      light.shape == PreparedLight::Shape::polygon || light.shape == PreparedLight::Shape::disk;
  const double there = flat ? std::abs(glm::dot(light.towards, to_light)) : std::sqrt(d2);
  return here * there / (d2 * d2);
}

struct WeighedRay {
  Ray ray;
  double weight = 0.0;
};

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

// Whether the plane of a point's triangle is its surface for as far as a leaf goes.
bool flat(const ShadowContext& block, const SurfacePoint& point) {
  return block.scene->features.deviation(point.triangle) <= 0.0f;
}

// Receivers on the patch for those of the points with the given numbers that lie on it.
void look_at_patch(const ShadowContext& block, const ShadowQuery& query, const SobolPixel& points,
                   std::uint32_t first, std::uint32_t end, RenderStatistics& counts) {
  ShadowWorkspace& work = *block.work;
  const SurfacePoint& point = query.lit.point;
  const Receiver middle = receiver_above(point, query.lit.light);
  work.receivers.clear();
  if (!has_patch(block, query.lit)) {
    for (std::uint32_t i = first; i < end; ++i) work.receivers.push_back({i, middle});
    return;
  }
  // Place the points in the leaf.
  const Bounds2 box = bounds_of(query.leaf.region);
  work.places.clear();
  work.place_of.clear();
  for (std::uint32_t i = first; i < end; ++i) {
    const glm::vec2 at = glm::mix(box.lo, box.hi, glm::vec2(points.pixel(i)));
    if (!query.leaf.region.holds(at)) continue;
    work.places.push_back(at);
    work.place_of.push_back(i);
  }
  if (flat(block, point)) {
    // Where the viewer sees the patch; the rays start clear of it.
    const glm::dvec3 lift = middle.position - glm::dvec3(point.position);
    const PlaneCrossings plane(*block.frame,
                               HalfSpace::through(glm::dvec3(point.position), middle.geometric));
    for (std::size_t k = 0; k < work.places.size(); ++k) {
      const auto on_plane = plane.at(glm::dvec2(work.places[k]));
      if (!on_plane) continue;
      work.receivers.push_back({work.place_of[k], middle});
      work.receivers.back().receiver.position = *on_plane + lift;
    }
    return;
  }
  // The plane of a bent surface leaves it within the patch.
  const std::uint32_t sheet = block.scene->features.sheet(point.triangle);
  block.view->look(work.places, work.seen, counts);
  for (std::size_t k = 0; k < work.places.size(); ++k) {
    const SurfacePoint& seen = work.seen[k];
    if (seen.triangle == Hit::none || block.scene->features.sheet(seen.triangle) != sheet) continue;
    work.receivers.push_back({work.place_of[k], receiver_above(seen, query.lit.light)});
  }
}

// Rays from all over the patch, in rounds until their mean is known as well as the leaf's weight
// deserves. `aim(points, number, receiver)`: the ray of the point of that number, unless it looks
// past the light.
template <typename Aim>
Visibility sampled_visibility(const ShadowContext& block, const ShadowQuery& query,
                              RenderStatistics& counts, double rays_a_finest_cell, Aim aim) {
  ShadowWorkspace& work = *block.work;
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
  const std::uint32_t most =
      few ? first_round : budget.samples(leaf.weight, rays_a_finest_cell, first_round);
  const double error = budget.standard_error(leaf.weight, intensity);
  const SobolPixel points{static_cast<int>(leaf.seed >> 32), static_cast<int>(leaf.seed),
                          query.lit.index};
  work.weights.clear();
  work.transmittances.clear();
  WeighedVisibility found;
  std::uint32_t drawn = 0;
  for (std::uint32_t wanted = first_round; wanted <= most; wanted *= 2) {
    // Aim the round's rays, and others instead of those that miss the patch or the light: a mean
    // over those of a fixed number of points that hit would favour the parts that they hit surely.
    work.rays.clear();
    while (work.weights.size() < wanted && drawn < most_points_a_ray * wanted) {
      const std::uint32_t first = drawn;
      drawn += wanted - static_cast<std::uint32_t>(work.weights.size());
      look_at_patch(block, query, points, first, drawn, counts);
      for (const NumberedReceiver& from : work.receivers) {
        const std::optional<WeighedRay> ray = aim(points, from.number, from.receiver);
        if (!ray || !(ray->weight > 0.0)) continue;
        work.rays.push_back(ray->ray);
        work.weights.push_back(ray->weight);
      }
    }
    // Trace them.
    const std::size_t before = work.transmittances.size();
    work.transmittances.resize(before + work.rays.size());
    block.scene->rays.transmittance(work.rays, std::span(work.transmittances).subspan(before),
                                    query.lit.light.own_part);
    counts.shadow_rays += work.rays.size();
    // End once the mean is known well enough, or too few points hit.
    found = WeighedVisibility::of(work.weights, work.transmittances);
    if (found.standard_error <= error || work.weights.size() < wanted) break;
  }
  return work.weights.empty() ? ray_visibility(block, query, counts) : found.mean;
}

}  // namespace

Visibility sampled_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                               const LightWindow& window, const Receiver& receiver,
                               RenderStatistics& counts) {
  const bool by_lobe = lobe_tells_apart(block, query.lit, Visibility(0.5));
  const auto aim = [&](const SobolPixel& points, std::uint32_t number,
                       const Receiver& from) -> std::optional<WeighedRay> {
    const glm::dvec2 on_light = points.light(number, query.lit.index);
    if (!window.holds(glm::vec2(on_light))) return std::nullopt;
    if (window.round() && glm::length(on_light - 0.5) > 0.5) return std::nullopt;
    glm::dvec3 target = window.towards(on_light);
    if (!window.infinitely_far()) target += receiver.position - from.position;
    WeighedRay found;
    found.weight = weight_of(query.lit.light, from, target);
    if (by_lobe && found.weight > 0.0) found.weight *= lobe_towards(query.lit, target);
    found.ray.origin = glm::vec3(from.position);
    found.ray.direction = glm::vec3(target);
    if (!window.infinitely_far())
      found.ray.t_far = way_to_light(query.lit.light, from.position, target);
    return found;
  };
  return sampled_visibility(block, query, counts, rays_to_all, aim);
}

Visibility sampled_shadow_around(const ShadowContext& block, const ShadowQuery& query,
                                 RenderStatistics& counts) {
  const auto aim = [&](const SobolPixel& points, std::uint32_t number,
                       const Receiver& from) -> std::optional<WeighedRay> {
    const glm::dvec2 on_light = points.light(number, query.lit.index);
    const LightSample sample = sample_light(query.lit.light, from, on_light.x, on_light.y);
    if (sample.irradiance == glm::vec3(0.0f)) return std::nullopt;
    WeighedRay found;
    found.weight = 1.0;
    found.ray.origin = glm::vec3(from.position);
    found.ray.direction = glm::vec3(sample.direction);
    found.ray.t_far = most_of_the_way * static_cast<float>(sample.distance);
    return found;
  };
  return sampled_visibility(block, query, counts, rays_to_all, aim);
}

Visibility sampled_hard_shadow(const ShadowContext& block, const ShadowQuery& query,
                               RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  const bool parallel = light.shape == PreparedLight::Shape::distant;
  const auto aim = [&](const SobolPixel&, std::uint32_t,
                       const Receiver& from) -> std::optional<WeighedRay> {
    const glm::dvec3 target = parallel ? light.towards : light.position - from.position;
    WeighedRay found;
    found.weight = std::max(0.0, glm::dot(from.normal, target));
    if (!parallel) {
      const double d2 = glm::dot(target, target);
      found.weight /= d2 * std::sqrt(d2);
    }
    found.ray.origin = glm::vec3(from.position);
    found.ray.direction = glm::vec3(target);
    if (!parallel) found.ray.t_far = most_of_the_way;
    return found;
  };
  return sampled_visibility(block, query, counts, rays_to_one, aim);
}

}  // namespace asos
