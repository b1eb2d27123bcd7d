#include "renderer/shadows/linear_shadow.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/shadow_ray.h"
#include "renderer/shadows/shadow.h"

#include <algorithm>
#include <cmath>

namespace asos {

std::optional<Frame> strip_around(const PreparedLight& light, const Receiver& receiver) {
  const glm::dvec3 middle = light.position - receiver.position;
  const glm::dvec3 across = glm::cross(middle, light.half_u);
  const double length = glm::length(light.half_u);
  if (!(glm::length(across) > 1e-9 * glm::length(middle) * length)) return std::nullopt;
  constexpr double width = 1e-4;
  const glm::dvec3 half_v = glm::normalize(across) * (width * length);
  return Frame::pyramid(receiver.position, middle - light.half_u - half_v, 2.0 * light.half_u,
                        2.0 * half_v);
}

Estimate linear_shadow(const ShadowContext& block, const ShadowQuery& query,
                       RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  const Receiver receiver = receiver_above(query.lit.point, query.lit.light);
  const glm::dvec3 middle = light.position - receiver.position;
  const auto strip = strip_around(light, receiver);
  if (!strip) return ray_visibility(block, query, counts);

  // Find all boundaries in a thin strip around the light, between it and the surface.
  const glm::dvec3 back = -glm::normalize(glm::cross(strip->base_v(), light.half_u));
  const double side = glm::dot(back, middle) > 0.0 ? -1.0 : 1.0;
  const HalfSpace between[2] = {
      {receiver.geometric, glm::dot(receiver.geometric, receiver.position)},
      {side * back,
       glm::dot(side * back, receiver.position) + (1.0 - 1e-5) * glm::dot(side * back, middle)}};
  Pyray pyray{*strip};
  pyray.bounds = query.found;
  pyray.bounds.within = between;
  const std::size_t most = std::size_t{1} << (levels_left(block.rules, query.leaf) + 3);
  const auto boundaries = block.work->tracer.boundaries(block.scene->features, pyray, 0.0f, most);

  // Collect the places where boundaries cross the light, and where the light sinks below the
  // horizons.
  std::vector<double>& ends = block.work->ends;
  ends.assign({-1.0, 1.0});
  if (boundaries) {
    for (const Segment& s : *boundaries) {
      if ((s.v0 > 0.5f) == (s.v1 > 0.5f)) continue;
      const double t = (0.5 - static_cast<double>(s.v0)) / (static_cast<double>(s.v1) - s.v0);
      ends.push_back(2.0 * (s.u0 + t * (static_cast<double>(s.u1) - s.u0)) - 1.0);
    }
  } else {
    // Too many boundaries: use `most` equal parts.
    for (std::size_t i = 1; i < most; ++i)
      ends.push_back(2.0 * static_cast<double>(i) / static_cast<double>(most) - 1.0);
  }
  for (const glm::dvec3& up : {receiver.normal, receiver.geometric}) {
    const double horizon = -glm::dot(up, middle) / glm::dot(up, light.half_u);
    if (std::abs(horizon) < 1.0) ends.push_back(horizon);
  }
  std::sort(ends.begin(), ends.end());

  // Send one ray to each part between these places.
  Visibility lit_parts(0.0);
  double all = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double t0 = std::max(-1.0, ends[i]), t1 = std::min(1.0, ends[i + 1]);
    if (!(t0 < t1)) continue;
    const double part = static_cast<double>(largest(segment_irradiance(light, receiver, t0, t1)));
    if (!(part > 0.0)) continue;
    const glm::dvec3 to = middle + 0.5 * (t0 + t1) * light.half_u;
    const double distance = glm::length(to);
    ++counts.shadow_rays;
    all += part;
    lit_parts +=
        part * Visibility(block.scene->rays.transmittance(
                   shadow_ray(query.lit.point, {to / distance, distance, {}}), light.own_part));
  }
  return Estimate::exact(all > 0.0 ? lit_parts / all : Visibility(0.0));
}

}  // namespace asos
