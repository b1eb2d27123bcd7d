#include "renderer/sampling/sobol_points.h"
#include "renderer/shadows/shadow_pyrays.h"

#include <algorithm>
#include <cmath>

// Where so much lies between a patch and a light that no part of the light's square is free of
// boundaries, pyrays cannot do better than well distributed samples (design section 5,
// "Saturation"): as many rays as the square has finest cells, each from another part of the patch
// to another part of the light, so that what is narrower than the patch is averaged over it at the
// same time.

namespace asos {
namespace {

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

}  // namespace

double ShadowPyrays::thicket_share(const Illumination& lit, const LightWindow& window,
                                   const Receiver& receiver, RenderStatistics& counts) {
  const std::uint32_t count = 1u << 2 * (levels_left() + 1);
  const SobolPixel points(static_cast<int>(leaf_.seed >> 32), static_cast<int>(leaf_.seed),
                          lit.index);
  // Where the viewer sees the patch; the rays start clear of it.
  const glm::dvec3 lift = static_cast<double>(clear_height(lit.point)) * receiver.geometric;
  const HalfSpace plane{receiver.geometric, glm::dot(receiver.geometric, receiver.position - lift)};
  const Square& s = leaf_.region.square;
  // The plane of a bent surface leaves it within the patch.
  const bool has_patch = lit.layer == 0 && flat(lit.point);
  work_.rays.clear();
  work_.weights.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec2 on_light = points.light(i, lit.index);
    if (!window.holds(glm::vec2(on_light))) continue;
    if (window.round() && glm::length(on_light - 0.5) > 0.5) continue;
    const glm::dvec2 on_patch = points.pixel(i);
    const glm::vec2 at(s.u + s.side * static_cast<float>(on_patch.x),
                       s.v + s.side * static_cast<float>(on_patch.y));
    glm::dvec3 origin = receiver.position;
    if (has_patch && leaf_.region.holds(at))
      origin = frame_.on_plane(glm::dvec2(at), plane).value_or(origin - lift) + lift;
    const glm::dvec3 target = window.towards(on_light);
    const double weight = weight_of(lit.light, receiver, target);
    if (!(weight > 0.0)) continue;
    Ray ray;
    ray.origin = glm::vec3(origin);
    if (window.infinitely_far()) {
      ray.direction = glm::vec3(target);
    } else {
      ray.direction = glm::vec3(receiver.position + target - origin);
      ray.t_far = most_of_the_way;
    }
    work_.rays.push_back(ray);
    work_.weights.push_back(weight);
  }
  work_.shares.resize(work_.rays.size());
  scene_.rays.transmittance(work_.rays, work_.shares, lit.light.own_part);
  counts.shadow_rays += work_.rays.size();
  double lit_part = 0.0, all = 0.0;
  for (std::size_t i = 0; i < work_.rays.size(); ++i) {
    all += work_.weights[i];
    lit_part += work_.weights[i] * static_cast<double>(work_.shares[i]);
  }
  return all > 0.0 ? lit_part / all : 0.0;
}

}  // namespace asos
