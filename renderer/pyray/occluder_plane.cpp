#include "renderer/pyray/occluder_plane.h"

#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <cmath>

namespace asos {

OccluderPlane OccluderPlane::plane(const Frame& frame, glm::dvec3 p, glm::dvec3 normal,
                                   double deviation) {
  const double length = glm::length(normal);
  if (!(length > 0.0)) return none();
  // Turn the normal towards the viewer.
  glm::dvec3 n = normal / length;
  const glm::dvec3 from_apex = p - frame.apex();
  if (glm::dot(n, frame.parallel() ? frame.direction() : from_apex) > 0.0) n = -n;
  // Solve the plane's equation for nearness.
  const double nu = glm::dot(n, frame.base_u());
  const double nv = glm::dot(n, frame.base_v());
  const double nc = glm::dot(n, frame.base_corner());
  const double d = -glm::dot(n, from_apex);

  OccluderPlane cover;
  cover.deviation = deviation;
  if (frame.parallel()) {
    // n.(U a + V b + W c) = -d with nearness -W.
    if (!(nc < 0.0)) return none();
    cover.distance = -nc;
    cover.per_u = nu / nc;
    cover.per_v = nv / nc;
    cover.at_origin = d / nc;
  } else {
    // n.(u a + v b + c) / nearness = -d.
    if (!(d > 0.0)) return none();
    cover.distance = d;
    cover.per_u = -nu / d;
    cover.per_v = -nv / d;
    cover.at_origin = -nc / d;
  }
  cover.nearness = frame.project(frame.homogeneous(p)).nearness;
  cover.valid = std::isfinite(cover.per_u) && std::isfinite(cover.per_v) &&
                std::isfinite(cover.at_origin) && (frame.parallel() || cover.nearness > 0.0);
  return cover;
}

OccluderPlane occluder_of(const Frame& frame, const World& world, const FeatureSet& features,
                          const Hit& hit) {
  const HitPlane plane = hit_plane(world, hit);
  const glm::dvec3 p = plane.point(hit.b1, hit.b2);
  if (!world.is_face(hit.triangle))
    return OccluderPlane::plane(frame, p, plane.normal(), features.deviation(hit.triangle));
  // Within a cell, a sphere deviates from the plane by at most the cell's width. The reason is that
  // its outline and the sample are equally far from where the plane meets the direction of the
  // outline. A stretched sphere deviates by the factor of its stretch. The part beyond the slack is
  // added to the deviation.
  OccluderPlane cover = OccluderPlane::plane(frame, p, plane.normal());
  if (!cover.valid) return cover;
  constexpr double diagonal = 1.5;
  const double beyond =
      std::max(0.0, diagonal * face_stretch(world.face(hit.triangle)) - occluder_slack);
  const double width = std::max(glm::length(frame.base_u()), glm::length(frame.base_v()));
  cover.deviation = std::min(world.face(hit.triangle).size,
                             beyond * (frame.parallel() ? width : width / cover.nearness));
  return cover;
}

CellOccluder CellOccluder::of(const OccluderPlane& cover, const Frame& frame, float side) {
  if (!cover.valid) return {};
  const double width = side * std::max(glm::length(frame.base_u()), glm::length(frame.base_v()));
  CellOccluder plane;
  if (frame.parallel()) {
    plane.per_u = static_cast<float>(cover.per_u);
    plane.per_v = static_cast<float>(cover.per_v);
    plane.at_origin = static_cast<float>(
        cover.at_origin - (occluder_slack * width + cover.deviation) / cover.distance);
    return plane;
  }
  const double slack = occluder_slack * width / cover.nearness + cover.deviation;
  const double back = cover.distance / (cover.distance + slack);
  plane.per_u = static_cast<float>(cover.per_u * back);
  plane.per_v = static_cast<float>(cover.per_v * back);
  plane.at_origin = static_cast<float>(cover.at_origin * back);
  return plane;
}

}  // namespace asos
