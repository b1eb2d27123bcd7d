#include "renderer/sampling/sobol_points.h"
#include "renderer/shadows/shadow_pyrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

// Where so much lies between a patch and a light that its boundaries cost more than rays do, pyrays
// cannot do better than well distributed samples (design section 5, "Saturation"): each ray from
// another part of the patch to another part of the light, so that what is narrower than the patch
// is averaged over it at the same time.

namespace asos {
namespace {

// Rays of the first round, for each further one of which their number doubles, and at most.
constexpr double first_rays_a_root = 16.0;
constexpr std::uint32_t least_rays = 8;
constexpr double rays_a_finest_cell = 4.0;

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

/// The lit part of weighted samples, and how well it is known: by quarters of the samples, each of
/// which is as well distributed as its size allows.
struct LitPart {
  double share = 0.0;
  double standard_error = std::numeric_limits<double>::infinity();

  static LitPart of(std::span<const double> weights, std::span<const float> shares) {
    std::array<double, 4> all{}, lit{};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const std::size_t quarter = 4 * i / weights.size();
      all[quarter] += weights[i];
      lit[quarter] += weights[i] * static_cast<double>(shares[i]);
    }
    const double whole = all[0] + all[1] + all[2] + all[3];
    if (!(whole > 0.0)) return {};
    LitPart part;
    part.share = (lit[0] + lit[1] + lit[2] + lit[3]) / whole;
    double squares = 0.0;
    for (std::size_t q = 0; q < 4; ++q) {
      const double off = lit[q] - part.share * all[q];
      squares += off * off;
    }
    // That all samples agree does not prove that all of the light does.
    part.standard_error = std::max(std::sqrt(4.0 / 3.0 * squares) / whole,
                                   0.25 / static_cast<double>(weights.size()));
    return part;
  }
};

}  // namespace

// How well a leaf's share has to be known: what is let pass for a pixel, so that the leaves of one
// pixel, whose errors are independent, stay within it together.
double ShadowPyrays::sampling_error_let_pass(const Illumination& lit) const {
  const glm::vec3 all = lit.reflected * lit.unshadowed;
  const auto intensity = std::min(1.0, static_cast<double>(std::max({all.x, all.y, all.z})));
  const double part = std::sqrt(leaf_.weight);
  return 0.5 * static_cast<double>(settings_.most_uneven) / (intensity * part);
}

// Receivers on the patch for the points with the given numbers; those without a place get none.
void ShadowPyrays::look_at_patch(const Illumination& lit, const SobolPixel& points,
                                 std::uint32_t first, std::uint32_t end, RenderStatistics& counts) {
  const Bounds2 box = bounds_of(leaf_.region);
  const Receiver middle = receiver_above(lit.point);
  work_.receivers.assign(end - first, std::nullopt);
  if (lit.layer > 0) {
    for (auto& receiver : work_.receivers) receiver = middle;
    return;
  }
  work_.places.clear();
  work_.place_of.clear();
  for (std::uint32_t i = first; i < end; ++i) {
    const glm::vec2 at = glm::mix(box.lo, box.hi, glm::vec2(points.pixel(i)));
    if (!leaf_.region.holds(at)) continue;
    work_.places.push_back(at);
    work_.place_of.push_back(i - first);
  }
  if (flat(lit.point)) {
    // Where the viewer sees the patch; the rays start clear of it.
    const glm::dvec3 lift = middle.position - glm::dvec3(lit.point.position);
    const HalfSpace plane{middle.geometric,
                          glm::dot(middle.geometric, glm::dvec3(lit.point.position))};
    for (std::size_t k = 0; k < work_.places.size(); ++k) {
      const auto on_plane = frame_.on_plane(glm::dvec2(work_.places[k]), plane);
      if (!on_plane) continue;
      Receiver receiver = middle;
      receiver.position = *on_plane + lift;
      work_.receivers[work_.place_of[k]] = receiver;
    }
    return;
  }
  // The plane of a bent surface leaves it within the patch.
  const std::uint32_t sheet = scene_.features.sheet(lit.point.triangle);
  view_.look(work_.places, work_.seen, counts);
  for (std::size_t k = 0; k < work_.places.size(); ++k) {
    const SurfacePoint& seen = work_.seen[k];
    if (seen.triangle == Hit::none || scene_.features.sheet(seen.triangle) != sheet) continue;
    work_.receivers[work_.place_of[k]] = receiver_above(seen);
  }
}

// Rays from all over the patch, in rounds until their mean is known as well as is let pass.
// `aim(number, receiver)`: the ray of a sample, unless it looks past the light.
template <typename Aim>
double ShadowPyrays::sampled_share(const Illumination& lit, RenderStatistics& counts, Aim aim) {
  const std::uint32_t first_round = std::bit_ceil(
      std::max(least_rays, static_cast<std::uint32_t>(first_rays_a_root * leaf_.weight)));
  const double finest_cells = leaf_.weight * std::ldexp(1.0, 2 * settings_.max_level);
  const std::uint32_t most = std::max(
      first_round, std::bit_ceil(static_cast<std::uint32_t>(rays_a_finest_cell * finest_cells)));
  const double let_pass = sampling_error_let_pass(lit);
  const SobolPixel points = points_of_leaf(lit);
  work_.weights.clear();
  work_.shares.clear();
  LitPart part;
  for (std::uint32_t first = 0, end = first_round; end <= most; first = end, end *= 2) {
    look_at_patch(lit, points, first, end, counts);
    work_.rays.clear();
    for (std::uint32_t i = first; i < end; ++i) {
      const auto& from = work_.receivers[i - first];
      if (!from) continue;
      const std::optional<WeighedRay> ray = aim(points.light(i, lit.index), *from);
      if (!ray || !(ray->weight > 0.0)) continue;
      work_.rays.push_back(ray->ray);
      work_.weights.push_back(ray->weight);
    }
    const std::size_t before = work_.shares.size();
    work_.shares.resize(before + work_.rays.size());
    scene_.rays.transmittance(work_.rays, std::span(work_.shares).subspan(before),
                              lit.light.own_part);
    counts.shadow_rays += work_.rays.size();
    part = LitPart::of(work_.weights, work_.shares);
    if (part.standard_error <= let_pass) break;
  }
  return work_.weights.empty() ? ray_share(lit, counts) : part.share;
}

SobolPixel ShadowPyrays::points_of_leaf(const Illumination& lit) const {
  return {static_cast<int>(leaf_.seed >> 32), static_cast<int>(leaf_.seed), lit.index};
}

double ShadowPyrays::thicket_share(const Illumination& lit, const LightWindow& window,
                                   const Receiver& receiver, RenderStatistics& counts) {
  const auto aim = [&](glm::dvec2 on_light, const Receiver& from) -> std::optional<WeighedRay> {
    if (!window.holds(glm::vec2(on_light))) return std::nullopt;
    if (window.round() && glm::length(on_light - 0.5) > 0.5) return std::nullopt;
    glm::dvec3 target = window.towards(on_light);
    if (!window.infinitely_far()) target += receiver.position - from.position;
    WeighedRay found;
    found.weight = weight_of(lit.light, from, target);
    found.ray.origin = glm::vec3(from.position);
    found.ray.direction = glm::vec3(target);
    if (!window.infinitely_far()) found.ray.t_far = most_of_the_way;
    return found;
  };
  return sampled_share(lit, counts, aim);
}

// Of a light without a size over a patch whose plane is not its surface.
double ShadowPyrays::bent_patch_share(const Illumination& lit, RenderStatistics& counts) {
  const bool parallel = lit.light.shape == PreparedLight::Shape::distant;
  const auto aim = [&](glm::dvec2, const Receiver& from) -> std::optional<WeighedRay> {
    const glm::dvec3 target = parallel ? lit.light.towards : lit.light.position - from.position;
    WeighedRay found;
    found.weight = std::max(0.0, glm::dot(from.normal, target));
    if (!parallel) found.weight /= std::pow(glm::dot(target, target), 1.5);
    found.ray.origin = glm::vec3(from.position);
    found.ray.direction = glm::vec3(target);
    if (!parallel) found.ray.t_far = most_of_the_way;
    return found;
  };
  return sampled_share(lit, counts, aim);
}

}  // namespace asos
