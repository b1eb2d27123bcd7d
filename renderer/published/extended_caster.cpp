#include "renderer/published/extended_caster.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Largest width of the pyray at the surface, in widths at the light: almost parallel.
constexpr double widest_cover = 0.99;

// Size of the patch in units of the light's edges, projected along the line between their centres,
// or of the light in units of the patch's edges: components along each unit edge.
struct Ratio {
  double along_first = 0.0, along_second = 0.0;  ///< summed over both edges

  [[nodiscard]] double larger() const { return std::max(along_first, along_second); }
};

Ratio ratio_of(glm::dvec3 first, glm::dvec3 second, glm::dvec3 unit_first, glm::dvec3 unit_second,
               glm::dvec3 along) {
  const double det = glm::dot(along, glm::cross(unit_first, unit_second));
  const auto by_first = [&](glm::dvec3 p) {
    return std::abs(glm::dot(p, glm::cross(unit_second, along)) / det);
  };
  const auto by_second = [&](glm::dvec3 p) {
    return std::abs(glm::dot(p, glm::cross(along, unit_first)) / det);
  };
  return {by_first(first) + by_first(second), by_second(first) + by_second(second)};
}

}  // namespace

std::optional<ExtendedPyray> ExtendedPyray::of(const LightPyramid& pyramid,
                                               const ShadowPatch& patch, Fit fit) {
  const glm::dvec3 m = pyramid.towards({0.5, 0.5});
  const glm::dvec3 a = pyramid.frame().base_u(), b = pyramid.frame().base_v();
  const auto& p = patch.corners;
  const glm::dvec3 right = 0.5 * (p[1] - p[0] + p[3] - p[2]);
  const glm::dvec3 down = 0.5 * (p[2] - p[0] + p[3] - p[1]);
  // Find the width of the pyray at the surface: the patch covers the light's projection, or the
  // other way round.
  const double covered = fit == Fit::inside ? 1.0 / ratio_of(a, b, right, down, m).larger()
                                            : ratio_of(right, down, a, b, m).larger();
  if (!(covered > 0.0) || !std::isfinite(covered)) return std::nullopt;
  if (fit == Fit::around && covered > widest_cover) return std::nullopt;
  const double width = std::min(covered, widest_cover);
  const double back = width / (1.0 - width);

  // Place the pyray's apex that far behind the surface, and bound the pyray by surface and light.
  ExtendedPyray pyray{
      Frame::pyramid(pyramid.frame().apex() - back * m, (1.0 + back) * m - 0.5 * (a + b), a, b),
      {},
      {},
      {},
      fit};
  pyray.surface = {patch.plane.normal, patch.plane.offset + patch.lift};
  pyray.between[0] = pyray.surface;
  const auto between = pyramid.between();
  pyray.between[1] = between.size() > 1 ? between[1] : pyray.surface;
  // Project the patch's outline into the pyray's square.
  static constexpr std::size_t around[4] = {0, 1, 3, 2};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = [&](std::size_t corner) {
      return pyray.frame.project(pyray.frame.homogeneous(p[around[corner % 4]]));
    };
    const FramePoint from = at(i), to = at(i + 1);
    pyray.outline[i] = {glm::vec2(from.u, from.v), glm::vec2(to.u, to.v)};
  }
  return pyray;
}

void ExtendedCaster::start(const ShadowScene& scene, bool see_through, const ExtendedPyray& pyray,
                           const LightPyramid& pyramid, std::int32_t ignored_part) {
  ShadowCaster::start(scene, see_through, pyray.frame, ignored_part);
  pyray_ = &pyray;
  pyramid_ = &pyramid;
}

std::optional<Ray> ExtendedCaster::ray_at(glm::vec2 p) const {
  if (pyray_->fit == ExtendedPyray::Fit::around && !winds_around(pyray_->outline, p))
    return std::nullopt;
  if (!pyramid_->holds(p)) return std::nullopt;
  if (pyramid_->round() && glm::length(p - 0.5f) > 0.5f) return std::nullopt;
  const auto start = pyray_->frame.on_plane(glm::dvec2(p), pyray_->surface);
  if (!start) return std::nullopt;
  const glm::dvec3 on_light =
      pyray_->frame.apex() + static_cast<double>(p.x) * pyray_->frame.base_u() +
      static_cast<double>(p.y) * pyray_->frame.base_v() + pyray_->frame.base_corner();
  Ray ray;
  ray.origin = glm::vec3(*start);
  ray.direction = glm::vec3(on_light) - ray.origin;
  ray.t_far = most_of_the_way;
  if (pyramid_->infinitely_far()) ray.t_far = std::numeric_limits<float>::infinity();
  return ray;
}

double ExtendedCaster::measure(double weight, const LeafRegion& /*region*/) const {
  return weight;
}

}  // namespace asos
