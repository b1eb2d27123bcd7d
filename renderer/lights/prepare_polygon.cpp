#include "renderer/lights/prepare_polygon.h"

#include "renderer/lights/light_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

using Outline2 = std::vector<glm::dvec2>;

/// Returns twice the area times the unit normal (Newell), counter-clockwise around it.
glm::dvec3 twice_area(const std::vector<glm::dvec3>& outline) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    sum += glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
  return sum;
}

/// Returns the square of the longest distance from the first corner.
double extent2(const std::vector<glm::dvec3>& outline) {
  double result = 0.0;
  for (const glm::dvec3& corner : outline) {
    const glm::dvec3 d = corner - outline[0];
    result = std::max(result, glm::dot(d, d));
  }
  return result;
}

double twice_area(const Outline2& outline) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - outline[0];
    const glm::dvec2 b = outline[i + 1] - outline[0];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

bool contains(const Outline2& outline, glm::dvec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i];
    const glm::dvec2 b = outline[i + 1 < outline.size() ? i + 1 : 0];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)))
      inside = !inside;
  }
  return inside;
}

/// Returns whether most of the inner outline's corners lie inside; some may lie on the outer one.
bool surrounds(const Outline2& outer, const Outline2& inner) {
  const auto count = std::count_if(inner.begin(), inner.end(),
                                   [&](glm::dvec2 corner) { return contains(outer, corner); });
  return 2 * static_cast<std::size_t>(count) > inner.size();
}

struct TurnedBox {
  glm::dvec2 low{std::numeric_limits<double>::infinity()};
  glm::dvec2 high{-std::numeric_limits<double>::infinity()};

  [[nodiscard]] double area() const { return (high.x - low.x) * (high.y - low.y); }
};

TurnedBox box_along(const Outline2& corners, glm::dvec2 axis) {
  TurnedBox box;
  for (const glm::dvec2& p : corners) {
    const glm::dvec2 turned(glm::dot(axis, p), axis.x * p.y - axis.y * p.x);
    box.low = glm::min(box.low, turned);
    box.high = glm::max(box.high, turned);
  }
  return box;
}

/// Returns the direction of a side along which the box is smallest. The smallest rectangle around a
/// set of points has a side along a side of their hull (Freeman and Shapira 1975).
glm::dvec2 best_axis(const std::vector<Outline2>& outlines) {
  Outline2 corners;
  for (const Outline2& outline : outlines)
    corners.insert(corners.end(), outline.begin(), outline.end());
  glm::dvec2 best(1.0, 0.0);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Outline2& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 side = outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i];
      const double length = glm::length(side);
      if (!(length > 0.0)) continue;
      const double area = box_along(corners, side / length).area();
      // Require a clear gain, since rounding must not decide between equal boxes.
      if (!(area < smallest * (1.0 - 1e-9))) continue;
      smallest = area;
      best = side / length;
    }
  }
  return best;
}

/// Orients outer outlines counter-clockwise and those inside an odd number of others clockwise.
void turn_the_right_way(std::vector<Outline2>& outlines) {
  std::vector<bool> hole(outlines.size(), false);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      if (k != i && surrounds(outlines[k], outlines[i])) hole[i] = !hole[i];
    }
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if ((twice_area(outlines[i]) < 0.0) != hole[i])
      std::reverse(outlines[i].begin(), outlines[i].end());
  }
}

}  // namespace

bool prepare_polygon(const std::vector<std::vector<glm::dvec3>>& outlines, glm::dvec3 direction,
                     PreparedLight& prepared) {
  glm::dvec3 largest(0.0);
  glm::dvec3 origin(0.0);
  for (const std::vector<glm::dvec3>& outline : outlines) {
    const glm::dvec3 area = twice_area(outline);
    const double length = glm::length(area);
    // The area of corners on one line is a rounding error.
    if (!(length > 1e-13 * extent2(outline)) || !(length > glm::length(largest))) continue;
    largest = area;
    origin = outline[0];
  }
  if (!(glm::dot(largest, largest) > 0.0)) return false;
  glm::dvec3 normal = glm::normalize(largest);
  if (glm::dot(normal, direction) < 0.0) normal = -normal;

  glm::dvec3 x_axis = any_perpendicular(normal);
  glm::dvec3 y_axis = glm::cross(normal, x_axis);
  std::vector<Outline2> flat;
  for (const std::vector<glm::dvec3>& outline : outlines) {
    if (outline.size() < 3) continue;
    Outline2& corners = flat.emplace_back();
    for (const glm::dvec3& corner : outline)
      corners.emplace_back(glm::dot(x_axis, corner - origin), glm::dot(y_axis, corner - origin));
  }

  const glm::dvec2 axis = best_axis(flat);
  const glm::dvec3 turned_x = axis.x * x_axis + axis.y * y_axis;
  y_axis = axis.x * y_axis - axis.y * x_axis;
  x_axis = turned_x;
  TurnedBox box;
  for (Outline2& corners : flat) {
    for (glm::dvec2& p : corners) {
      p = {glm::dot(axis, p), axis.x * p.y - axis.y * p.x};
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
  }
  const glm::dvec2 middle = 0.5 * (box.low + box.high);
  for (Outline2& corners : flat) {
    for (glm::dvec2& p : corners) p -= middle;
  }
  turn_the_right_way(flat);
  PolygonRows rows = PolygonRows::of(flat);
  if (!(rows.area > 0.0)) return false;

  prepared.position = origin + middle.x * x_axis + middle.y * y_axis;
  prepared.towards = normal;
  prepared.half_u = 0.5 * (box.high.x - box.low.x) * x_axis;
  prepared.half_v = 0.5 * (box.high.y - box.low.y) * y_axis;
  prepared.area = rows.area;
  prepared.rows = std::move(rows);
  prepared.outlines.clear();
  for (const Outline2& corners : flat) {
    std::vector<glm::dvec3>& outline = prepared.outlines.emplace_back();
    for (const glm::dvec2& p : corners)
      outline.push_back(prepared.position + p.x * x_axis + p.y * y_axis);
  }
  return true;
}

}  // namespace asos
