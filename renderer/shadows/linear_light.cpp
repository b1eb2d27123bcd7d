#include "renderer/shading/shadow_ray.h"
#include "renderer/shadows/shadow_pyrays.h"

#include <algorithm>
#include <cmath>

// Linear lights (GI'93, "Linear Light Sources"): where papers split pyrays in two, all boundaries
// that cross the line are found at once.

namespace asos {
namespace {

double largest(glm::vec3 v) {
  return static_cast<double>(std::max({v.x, v.y, v.z}));
}

}  // namespace

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

// The parts of a linear light that are seen: between the places where boundaries cross it, one ray
// each. Only its middle line counts of the thin strip that is searched.
double ShadowPyrays::segment_share(const Illumination& lit, const SearchBounds& found,
                                   RenderStatistics& counts) {
  const Receiver receiver = receiver_above(lit.point);
  const glm::dvec3 middle = lit.light.position - receiver.position;
  const auto strip = strip_around(lit.light, receiver);
  if (!strip) return ray_share(lit, counts);
  const Frame& frame = *strip;
  const glm::dvec3 across = frame.base_v();
  const glm::dvec3 back = -glm::normalize(glm::cross(across, lit.light.half_u));
  const double side = glm::dot(back, middle) > 0.0 ? -1.0 : 1.0;
  const HalfSpace between[2] = {
      {receiver.geometric, glm::dot(receiver.geometric, receiver.position)},
      {side * back,
       glm::dot(side * back, receiver.position) + (1.0 - 1e-5) * glm::dot(side * back, middle)}};
  SearchBounds bounds = found;
  bounds.within = between;
  HitLists& lists = work_.lists;
  lists.reset(scene_.features, frame, 0.0f, bounds);
  const Square whole{0.0f, 0.0f, 1.0f};
  const std::size_t most = std::size_t{1} << (levels_left() + 3);
  std::vector<double>& ends = work_.ends;
  ends.assign({-1.0, 1.0});
  HitLists::List& crossing = work_.list;
  crossing.clear();
  bool told_apart = true;
  for (const std::uint32_t i : lists.root())
    told_apart = told_apart && lists.tell_apart(i, whole, 0.0f, most, crossing);
  if (told_apart) {
    for (const std::uint32_t i : crossing) {
      const Segment& s = lists.segment(i);
      if ((s.v0 > 0.5f) == (s.v1 > 0.5f)) continue;
      const double t = (0.5 - static_cast<double>(s.v0)) / (static_cast<double>(s.v1) - s.v0);
      ends.push_back(2.0 * (s.u0 + t * (static_cast<double>(s.u1) - s.u0)) - 1.0);
    }
  } else {
    // Too many: as many equal parts.
    for (std::size_t i = 1; i < most; ++i)
      ends.push_back(2.0 * static_cast<double>(i) / static_cast<double>(most) - 1.0);
  }
  for (const glm::dvec3& up : {receiver.normal, receiver.geometric}) {
    const double horizon = -glm::dot(up, middle) / glm::dot(up, lit.light.half_u);
    if (std::abs(horizon) < 1.0) ends.push_back(horizon);
  }
  std::sort(ends.begin(), ends.end());
  double lit_parts = 0.0, all = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double t0 = std::max(-1.0, ends[i]), t1 = std::min(1.0, ends[i + 1]);
    if (!(t0 < t1)) continue;
    const double part = largest(segment_irradiance(lit.light, receiver, t0, t1));
    if (!(part > 0.0)) continue;
    const glm::dvec3 to = middle + 0.5 * (t0 + t1) * lit.light.half_u;
    const double distance = glm::length(to);
    ++counts.shadow_rays;
    all += part;
    lit_parts +=
        part * static_cast<double>(scene_.rays.transmittance(
                   shadow_ray(lit.point, {to / distance, distance, {}}), lit.light.own_part));
  }
  return all > 0.0 ? lit_parts / all : 0.0;
}

}  // namespace asos
