#include "renderer/shadows/light_pyramid.h"

#include "renderer/lights/form_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr double pi = std::numbers::pi;

// Distance of the end of shadow pyrays from a light, relative to the light's distance. The light's
// own surface must not shade it.
constexpr double before_light = 1e-5;

// Converts an offset from the first corner of a rectangle to coordinates of the square.
glm::vec2 in_square(glm::dvec3 offset, glm::dvec3 half_u, glm::dvec3 half_v) {
  return {glm::dot(offset, half_u) / (2.0 * glm::dot(half_u, half_u)),
          glm::dot(offset, half_v) / (2.0 * glm::dot(half_v, half_v))};
}

// Converts a point of a flat light's plane to coordinates of the square.
glm::vec2 in_window(const PreparedLight& light, glm::dvec3 p) {
  return in_square(p - (light.position - light.half_u - light.half_v), light.half_u, light.half_v);
}

// Returns a point of the disk that decides whether an arc of its rim is inside a region. It is just
// inside of the arc's centre, since the rim itself touches the square's sides, which may bound the
// region.
glm::dvec2 within_arc(double from, double to) {
  constexpr double most = 1e-6;  // of the radius
  const double sagitta = 1.0 - std::cos(std::min(0.5 * (to - from), pi));
  const double radius = 0.5 * (1.0 - std::min(most, 0.25 * sagitta));
  const double middle = 0.5 * (from + to);
  return 0.5 + radius * glm::dvec2(std::cos(middle), std::sin(middle));
}

}  // namespace

LightPyramid::LightPyramid(const PreparedLight& light, const LightWindow& window,
                           const Receiver& receiver, const Frame& frame)
    : frame_(frame), normal_(receiver.normal) {
  const glm::dvec3 middle = towards({0.5, 0.5});
  const glm::dvec3 face = glm::cross(frame_.base_u(), frame_.base_v());
  orientation_ = glm::dot(face, middle) < 0.0 ? 1.0 : -1.0;
  round_ = window.inside == LightWindow::Inside::ellipse;
  infinite_ = light.traits().infinite;

  const glm::dvec3 up = receiver.geometric;
  between_[0] = {up, glm::dot(up, frame_.apex())};
  const glm::dvec3 back = orientation_ * glm::normalize(face);
  const double distance = -glm::dot(back, middle);
  // The outlines of objects that pass through the light are on the light itself.
  const double way = light.intersections.empty() ? 1.0 - before_light : 1.0;
  between_[1] = {back, glm::dot(back, frame_.apex()) - distance * way};

  if (window.inside == LightWindow::Inside::outlines) add_outlines(light);
  if (window.inside == LightWindow::Inside::silhouette) add_silhouette(window);
  add_cuts(light);
  add_horizon(receiver.normal);
  if (receiver.geometric != receiver.normal) add_horizon(receiver.geometric);
}

std::optional<LightPyramid> LightPyramid::of(const PreparedLight& light, const Receiver& receiver) {
  const auto around = light_window(light, receiver.position);
  if (!around) return std::nullopt;
  const glm::dvec3 face = glm::cross(around->half_u, around->half_v);
  const double height = glm::dot(face, around->middle);
  const double size = glm::length(face) * glm::length(around->middle);
  if (!(std::abs(height) > 1e-12 * size)) return std::nullopt;
  return LightPyramid(
      light, *around, receiver,
      Frame::pyramid(receiver.position, around->middle - around->half_u - around->half_v,
                     2.0 * around->half_u, 2.0 * around->half_v));
}

// Adds the horizon, which is a straight line of the square, if it crosses the square.
void LightPyramid::add_horizon(glm::dvec3 normal) {
  const glm::dvec3 line(glm::dot(normal, frame_.base_u()), glm::dot(normal, frame_.base_v()),
                        glm::dot(normal, frame_.base_corner()));
  const auto height = [&](glm::dvec2 p) { return line.x * p.x + line.y * p.y + line.z; };
  static constexpr glm::dvec2 corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glm::dvec2 ends[2];
  int found = 0;
  bool below = false;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 p = corners[i], q = corners[(i + 1) % 4];
    const double hp = height(p), hq = height(q);
    below |= hp < 0.0;
    if ((hp < 0.0) != (hq < 0.0) && found < 2) ends[found++] = p + hp / (hp - hq) * (q - p);
  }
  if (!below) return;
  horizons_[static_cast<std::size_t>(horizon_count_++)] = line;
  if (found == 2) boundaries_.push_back({glm::vec2(ends[0]), glm::vec2(ends[1])});
}

void LightPyramid::add_outlines(const PreparedLight& light) {
  for (const auto& outline : light.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      boundaries_.push_back(
          {in_window(light, outline[i]), in_window(light, outline[(i + 1) % outline.size()])});
  }
  outline_sides_ = boundaries_.size();
}

void LightPyramid::add_silhouette(const LightWindow& window) {
  const auto corner = [&](std::size_t i) {
    const glm::dvec3 p = window.outline[i % window.outline.size()];
    return in_square(p - (window.middle - window.half_u - window.half_v), window.half_u,
                     window.half_v);
  };
  for (std::size_t i = 0; i < window.outline.size(); ++i)
    boundaries_.push_back({corner(i), corner(i + 1)});
  outline_sides_ = boundaries_.size();
}

void LightPyramid::add_cuts(const PreparedLight& light) {
  for (const LightIntersection& cut : light.intersections)
    boundaries_.push_back({in_window(light, cut.from), in_window(light, cut.to)});
}

bool LightPyramid::holds(glm::vec2 p) const {
  for (int i = 0; i < horizon_count_; ++i) {
    const glm::dvec3 line = horizons_[static_cast<std::size_t>(i)];
    if (line.x * p.x + line.y * p.y + line.z < 0.0) return false;
  }
  if (outline_sides_ == 0) return true;
  return winds_around(std::span(boundaries_).first(outline_sides_), p);
}

double LightPyramid::form(const LeafRegion& region) const {
  double sum = 0.0;
  if (round_) {
    sum = round_form(region);
  } else {
    region.for_each_edge([&](const BorderEdge& side) {
      sum += contour_side(towards(side.from), towards(side.to), normal_);
    });
  }
  // Parts below the horizon would count as negative light.
  return std::max(0.0, orientation_ * sum);
}

// Returns the contour sum along the disk's rim between two angles, counter-clockwise: half of the
// integral of n . (dr x r) / r^2, by eight Gauss-Legendre points on each sixth of the circle.
double LightPyramid::arc(double from, double to) const {
  static constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                     0.9602898564975363};
  static constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                       0.1012285362903763};
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / (pi / 3.0))));
  const double half = 0.5 * (to - from) / pieces;
  const auto value = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 r = towards({0.5 + 0.5 * c, 0.5 + 0.5 * s});
    const glm::dvec3 along = 0.5 * (c * frame_.base_v() - s * frame_.base_u());
    return glm::dot(normal_, glm::cross(along, r)) / glm::dot(r, r);
  };
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const double middle = from + (2 * i + 1) * half;
    for (int k = 0; k < 4; ++k)
      sum += weight[k] * (value(middle - half * node[k]) + value(middle + half * node[k]));
  }
  return 0.5 * half * sum;
}

// Returns the contour sum of a disk: over the region's sides inside the disk, and over the rim
// inside the region.
double LightPyramid::round_form(const LeafRegion& region) const {
  constexpr std::size_t most_crossings = 64;
  std::array<double, most_crossings> angles;
  std::size_t count = 0;
  double sum = 0.0;
  // Sum up the sides inside the disk, and record where they cross the rim.
  region.for_each_edge([&](const BorderEdge& side) {
    const glm::dvec2 p = glm::dvec2(side.from) - 0.5;
    const glm::dvec2 d = glm::dvec2(side.to) - glm::dvec2(side.from);
    const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - 0.25;
    const double under = b * b - a * c;
    // A side that only touches the rim, as those of the whole square do, cuts nothing off.
    if (!(under > 1e-12 * a)) return;
    const double root = std::sqrt(under);
    const double enter = (-b - root) / a, leave = (-b + root) / a;
    const double t0 = std::max(0.0, enter), t1 = std::min(1.0, leave);
    if (!(t0 < t1)) return;
    sum += contour_side(towards(p + t0 * d + 0.5), towards(p + t1 * d + 0.5), normal_);
    for (const double t : {enter, leave}) {
      if (t < 0.0 || t > 1.0 || count == most_crossings) continue;
      const glm::dvec2 at = p + t * d;
      angles[count++] = std::atan2(at.y, at.x);
    }
  });
  // Add the arcs of the rim inside the region.
  std::sort(angles.begin(), angles.begin() + count);
  if (count == 0) angles[count++] = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double from = angles[i];
    const double to = i + 1 < count ? angles[i + 1] : angles[0] + 2.0 * pi;
    if (to - from > 1e-12 && region.holds(within_arc(from, to))) sum += arc(from, to);
  }
  return sum;
}

float end_before_light(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards) {
  constexpr double most = 1.0 - before_light;
  return static_cast<float>(most * way_to_light(light, from, towards));
}

}  // namespace asos
