#include "renderer/shadows/patch_caster.h"

#include <algorithm>
#include <cmath>

namespace asos {

std::optional<Frame> PatchCaster::frame_from(glm::dvec3 light, const ShadowPatch& patch) {
  // Solve for base vectors through the four directions d: c = s0 d0, c + a = s1 d1, c + b = s2 d2
  // and c + a + b = d3. So s1 d1 + s2 d2 - s0 d0 = d3.
  glm::dvec3 d[4];
  for (std::size_t i = 0; i < 4; ++i) d[i] = patch.corners[i] - light;
  const double det = glm::dot(d[1], glm::cross(d[2], d[0]));
  const double s1 = glm::dot(d[3], glm::cross(d[2], d[0])) / det;
  const double s2 = glm::dot(d[3], glm::cross(d[0], d[1])) / det;
  const double s0 = -glm::dot(d[3], glm::cross(d[1], d[2])) / det;
  const double size = std::max({glm::dot(d[0], d[0]), glm::dot(d[1], d[1]), glm::dot(d[2], d[2])});
  if (!(std::abs(det) > 1e-24 * size * std::sqrt(size)) || !(s0 > 0.0 && s1 > 0.0 && s2 > 0.0))
    return std::nullopt;
  const glm::dvec3 c = s0 * d[0];
  return Frame::pyramid(light, c, s1 * d[1] - c, s2 * d[2] - c);
}

std::optional<Frame> PatchCaster::frame_along(glm::dvec3 towards, double reach,
                                              const ShadowPatch& patch) {
  const auto& p = patch.corners;
  const glm::dvec3 a = 0.5 * (p[1] - p[0] + p[3] - p[2]);
  const glm::dvec3 b = 0.5 * (p[2] - p[0] + p[3] - p[1]);
  const double det = glm::dot(a, glm::cross(b, towards));
  if (!(std::abs(det) > 1e-12 * glm::length(a) * glm::length(b))) return std::nullopt;
  const glm::dvec3 middle = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  // Extent of the corners perpendicular to the light's direction, in the parallelogram's edges.
  double u = 0.0, v = 0.0;
  for (const glm::dvec3& corner : p) {
    const glm::dvec3 d = corner - middle;
    u = std::max(u, std::abs(glm::dot(d, glm::cross(b, towards)) / det));
    v = std::max(v, std::abs(glm::dot(d, glm::cross(towards, a)) / det));
  }
  constexpr double around = 2.0 * (1.0 + 1e-6);
  const glm::dvec3 wide = around * u * a, high = around * v * b;
  return Frame::prism(middle - 0.5 * (wide + high) + reach * towards, -towards, wide, high);
}

void PatchCaster::start(const ShadowScene& scene, bool see_through, const Frame& frame,
                        const ShadowPatch& patch, const Frame* viewer, std::int32_t ignored_part) {
  ShadowCaster::start(scene, see_through, frame, ignored_part);
  viewer_ = viewer;
  frame_ = &frame;
  patch_ = &patch;
}

std::optional<Ray> PatchCaster::ray_at(glm::vec2 p) const {
  if (!patch_->border.empty() && !winds_around(patch_->border, p)) return std::nullopt;
  const auto target = frame_->on_plane(glm::dvec2(p), patch_->plane);
  if (!target) return std::nullopt;
  // Start clear of the surface along the direction to the light, so that the ray keeps its place in
  // the square; at most 64 times as far for grazing light.
  const glm::dvec3 towards =
      frame_->parallel() ? -frame_->direction() : glm::normalize(frame_->apex() - *target);
  const double cosine = std::max(glm::dot(towards, patch_->plane.normal), 1.0 / 64.0);
  Ray ray;
  ray.origin = glm::vec3(*target + patch_->lift / cosine * towards);
  if (frame_->parallel()) {
    ray.direction = glm::vec3(-frame_->direction());
  } else {
    ray.direction = glm::vec3(frame_->apex()) - ray.origin;
    ray.t_far = most_of_the_way;
  }
  return ray;
}

double PatchCaster::measure(double weight, const LeafRegion& region) const {
  if (!viewer_) return weight;
  // Project the region to the viewer's frame.
  const auto seen = [&](glm::vec2 p) {
    const auto at = frame_->on_plane(glm::dvec2(p), patch_->plane);
    const FramePoint q = viewer_->project(viewer_->homogeneous(at.value_or(patch_->corners[0])));
    return glm::dvec2(q.u, q.v);
  };
  double twice = 0.0;
  region.for_each_edge([&](const BorderEdge& side) {
    const glm::dvec2 a = seen(side.from), b = seen(side.to);
    twice += a.x * b.y - a.y * b.x;
  });
  return 0.5 * std::abs(twice);
}

}  // namespace asos
