#include "renderer/pyray/cover.h"

#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <cmath>

namespace asos {

Cover Cover::plane(const Frame& frame, glm::dvec3 p, glm::dvec3 normal, double departure) {
  const double length = glm::length(normal);
  if (!(length > 0.0)) return none();
  glm::dvec3 n = normal / length;
  const glm::dvec3 from_apex = p - frame.apex();
  if (glm::dot(n, frame.parallel() ? frame.direction() : from_apex) > 0.0) n = -n;
  const double nu = glm::dot(n, frame.base_u());
  const double nv = glm::dot(n, frame.base_v());
  const double nc = glm::dot(n, frame.base_corner());
  const double d = -glm::dot(n, from_apex);

  Cover cover;
  cover.departure = departure;
  if (frame.parallel()) {
    // n.(U a + V b + W c) = -d with q = -W.
    if (!(nc < 0.0)) return none();
    cover.distance = -nc;
    cover.qu = nu / nc;
    cover.qv = nv / nc;
    cover.q1 = d / nc;
  } else {
    // n.(u a + v b + c) / q = -d.
    if (!(d > 0.0)) return none();
    cover.distance = d;
    cover.qu = -nu / d;
    cover.qv = -nv / d;
    cover.q1 = -nc / d;
  }
  cover.q = frame.project(frame.homogeneous(p)).q;
  cover.valid = std::isfinite(cover.qu) && std::isfinite(cover.qv) && std::isfinite(cover.q1) &&
                (frame.parallel() || cover.q > 0.0);
  return cover;
}

Cover cover_of(const Frame& frame, const World& world, const FeatureSet& features, const Hit& hit) {
  const HitPlane plane = hit_plane(world, hit);
  const glm::dvec3 p = plane.point(hit.b1, hit.b2);
  if (!world.is_face(hit.triangle))
    return Cover::plane(frame, p, plane.normal(), features.departure(hit.triangle));
  // Within a cell a sphere leaves the plane by no more than the cell is wide: its outline and the
  // point are equally far from where the plane meets the way to the outline. A stretched one leaves
  // it by as much more as it is stretched. What the slack does not hold goes into the departure.
  Cover cover = Cover::plane(frame, p, plane.normal());
  if (!cover.valid) return cover;
  constexpr double diagonal = 1.5;
  const double beyond =
      std::max(0.0, diagonal * face_stretch(world.face(hit.triangle)) - cover_slack);
  const double width = std::max(glm::length(frame.base_u()), glm::length(frame.base_v()));
  cover.departure = std::min(world.face(hit.triangle).size,
                             beyond * (frame.parallel() ? width : width / cover.q));
  return cover;
}

HidingPlane HidingPlane::of(const Cover& cover, const Frame& frame, float side) {
  if (!cover.valid) return {};
  const double width = side * std::max(glm::length(frame.base_u()), glm::length(frame.base_v()));
  HidingPlane plane;
  if (frame.parallel()) {
    plane.qu = static_cast<float>(cover.qu);
    plane.qv = static_cast<float>(cover.qv);
    plane.q1 =
        static_cast<float>(cover.q1 - (cover_slack * width + cover.departure) / cover.distance);
    return plane;
  }
  const double slack = cover_slack * width / cover.q + cover.departure;
  const double back = cover.distance / (cover.distance + slack);
  plane.qu = static_cast<float>(cover.qu * back);
  plane.qv = static_cast<float>(cover.qv * back);
  plane.q1 = static_cast<float>(cover.q1 * back);
  return plane;
}

}  // namespace asos
