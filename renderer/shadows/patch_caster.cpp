#include "renderer/shadows/patch_caster.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// How much of the way to a light a shadow ray goes: its own glass does not shade it.
constexpr float most_of_the_way = 1.0f - 1e-5f;

}  // namespace

std::optional<Frame> PatchCaster::frame_from(glm::dvec3 light, const ShadowPatch& patch) {
  // Base vectors through four given directions d: c = s0 d0, c + a = s1 d1, c + b = s2 d2 and
  // c + a + b = d3, so that s1 d1 + s2 d2 - s0 d0 = d3.
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
  return Frame::prism(middle - 0.5 * (a + b) + reach * towards, -towards, a, b);
}

void PatchCaster::start(const Frame& frame, const ShadowPatch& patch, std::int32_t ignored_part) {
  ShadowCaster::start(frame, ignored_part);
  frame_ = &frame;
  patch_ = &patch;
}

std::optional<Ray> PatchCaster::ray_at(glm::vec2 p) const {
  if (!patch_->sides.empty() && !winds_around(patch_->sides, p)) return std::nullopt;
  const auto target = frame_->on_plane(glm::dvec2(p), patch_->plane);
  if (!target) return std::nullopt;
  Ray ray;
  ray.origin = glm::vec3(*target + patch_->lift * patch_->plane.normal);
  if (frame_->parallel()) {
    ray.direction = glm::vec3(-frame_->direction());
  } else {
    ray.direction = glm::vec3(frame_->apex()) - ray.origin;
    ray.t_far = most_of_the_way;
  }
  return ray;
}

double PatchCaster::measure(double weight, const LeafRegion& /*region*/) const {
  return weight;
}

}  // namespace asos
