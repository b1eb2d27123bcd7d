#include "renderer/stability/closed_forms.h"

#include <cmath>
#include <cstddef>

namespace asos::stability {
namespace {

double area(const std::vector<glm::dvec3>& polygon) {
  double twice = 0.0;
  // Relative to the first corner: a small polygon far from the origin would cancel otherwise.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::dvec3 a = polygon[i] - polygon[0];
    const glm::dvec3 b = polygon[i + 1] - polygon[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

double PictureView::pixels_per_unit() const {
  return camera.type == Camera::Type::perspective ? 0.5 * height / std::tan(0.5 * camera.fov_y_rad)
                                                  : height / camera.height;
}

std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, glm::dvec3 normal,
                                double offset) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p = polygon[i];
    const glm::dvec3 q = polygon[(i + 1) % polygon.size()];
    const double hp = glm::dot(normal, p) + offset;
    const double hq = glm::dot(normal, q) + offset;
    if (hp >= 0.0) kept.push_back(p);
    if ((hp < 0.0) != (hq < 0.0)) kept.push_back(p + hp / (hp - hq) * (q - p));
  }
  return kept;
}

double coverage(const PictureView& view, const std::vector<glm::dvec3>& polygon, int x, int y) {
  // Transform to pixels relative to the pixel's centre: (u, v, 1) w, where w is the depth, or 1 for
  // parallel rays.
  const glm::dmat4 m = view.camera.world_from_camera;
  const bool perspective = view.camera.type == Camera::Type::perspective;
  const double scale = view.pixels_per_unit();
  const double middle_x = x + 0.5 - 0.5 * view.width;
  const double middle_y = y + 0.5 - 0.5 * view.height;
  std::vector<glm::dvec3> seen;
  for (const glm::dvec3& p : polygon) {
    const glm::dvec3 d = p - glm::dvec3(m[3]);
    const double w = perspective ? -glm::dot(d, glm::dvec3(m[2])) : 1.0;
    seen.emplace_back(glm::dot(d, glm::dvec3(m[0])) * scale - middle_x * w,
                      -glm::dot(d, glm::dvec3(m[1])) * scale - middle_y * w, w);
  }
  for (const glm::dvec3& side : {glm::dvec3(1, 0, 0.5), glm::dvec3(-1, 0, 0.5),
                                 glm::dvec3(0, 1, 0.5), glm::dvec3(0, -1, 0.5)})
    seen = clipped(seen, side, 0.0);
  if (seen.size() < 3) return 0.0;
  for (glm::dvec3& p : seen) p /= p.z;
  return area(seen);
}

double faces_radiance(const PictureView& view, const std::vector<Face>& faces, int x, int y) {
  double radiance = background;
  for (const Face& face : faces)
    radiance +=
        coverage(view, face.corners, x, y) * (static_cast<double>(face.colour) - background);
  return radiance;
}

double rounding_bound(const PictureView& view, const RoundingCase& rounded) {
  const double distance = view.camera.type == Camera::Type::perspective ? rounded.distance : 1.0;
  const double moved_pixels =
      rounded.roundings * rounding * rounded.lengths * view.pixels_per_unit() / distance;
  return rounded.contrast * (rounded.edges * std::sqrt(2.0) * moved_pixels + 16.0 * rounding);
}

double contour_illuminance(const std::vector<glm::dvec3>& polygon) {
  const std::vector<glm::dvec3> above = clipped(polygon, {0, 1, 0}, 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const glm::dvec3 a = above[i];
    const glm::dvec3 b = above[(i + 1) % above.size()];
    const glm::dvec3 across = glm::cross(a, b);
    const double length = glm::length(across);
    if (length > 0.0) sum += across.y / length * std::atan2(length, glm::dot(a, b));
  }
  return 0.5 * std::abs(sum);
}

}  // namespace asos::stability
