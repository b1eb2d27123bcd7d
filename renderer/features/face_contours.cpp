#include "renderer/features/face_contours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asos {
namespace {

constexpr int around = 256;
constexpr int steps_along = 128;
constexpr int bisections = 40;

// Returns the distance from the other face, in the space of its unit surface, within which a point
// counts as on it. Where two faces coincide the sign is rounding noise: every cell would be cut,
// and boundaries would cover the whole face.
double touching(const ShapeFace& face, const ShapeFace& other) {
  constexpr double least = 1e-9;  // 1/100 of the single precision of all input
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  const FaceBounds box = bounds_of(face);
  const glm::dvec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi)) + glm::abs(other.origin);
  double steepest = 0.0;
  for (int i = 0; i < 3; ++i) steepest = std::max(steepest, glm::length(other.unit_from_world[i]));
  return least + rounding * glm::length(farthest) * steepest;
}

class Contours {
 public:
  Contours(const ShapeFace& face, const ShapeFace& other)
      : face_(face), other_(other), touching_(touching(face, other)) {}

  std::vector<FaceCrossing> find() {
    std::vector<double> low = row(0), high;
    for (int v = 0; v < steps_along; ++v) {
      high = row(v + 1);
      for (int u = 0; u < around; ++u) cut({u, v}, low, high);
      low.swap(high);
    }
    return std::move(found_);
  }

 private:
  struct Place {
    int u, v;
  };

  [[nodiscard]] glm::dvec3 point(double u, double v) const {
    // The seam must be the same line from both sides.
    return face_point(face_, u == around ? 0.0 : u / around, v / steps_along).position;
  }
  // The other face's equation, above 0 outside.
  [[nodiscard]] double outside(glm::dvec3 p) const {
    const glm::dvec3 q = other_.unit(p);
    switch (other_.kind) {
      case ShapeFace::Kind::sphere:
        return glm::dot(q, q) - 1.0 - touching_;
      case ShapeFace::Kind::disk:
        return q.y - touching_;
      case ShapeFace::Kind::side:
        break;
    }
    return std::hypot(q.x, q.z) - other_.radius_at(q.y) - touching_;
  }
  // Returns a value above 0 where the surface of the other face's equation continues beyond the
  // face.
  [[nodiscard]] double beyond(glm::dvec3 p) const {
    const glm::dvec3 q = other_.unit(p);
    if (other_.kind == ShapeFace::Kind::sphere) return -1.0;
    if (other_.kind == ShapeFace::Kind::disk) return q.x * q.x + q.z * q.z - 1.0;
    return std::abs(q.y - 0.5) - 0.5;
  }

  [[nodiscard]] std::vector<double> row(int v) const {
    std::vector<double> values;
    for (int u = 0; u <= around; ++u) values.push_back(outside(point(u, v)));
    return values;
  }

  // Returns where the sign changes between two neighbours of the grid, the lower one first.
  [[nodiscard]] glm::dvec3 crossing(Place a, Place b) const {
    double t0 = 0.0, t1 = 1.0;
    const auto at = [&](double t) { return point(a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)); };
    const bool first = outside(at(0.0)) > 0.0;
    for (int i = 0; i < bisections; ++i) {
      const double t = 0.5 * (t0 + t1);
      ((outside(at(t)) > 0.0) == first ? t0 : t1) = t;
    }
    return at(0.5 * (t0 + t1));
  }

  // Finds a cell's contour: one piece, or two where diagonal corners agree and neighbours do not.
  void cut(Place c, const std::vector<double>& low, const std::vector<double>& high) {
    const auto u = static_cast<std::size_t>(c.u);
    const bool corner[4] = {low[u] > 0.0, low[u + 1] > 0.0, high[u + 1] > 0.0, high[u] > 0.0};
    const Place places[4] = {c, {c.u + 1, c.v}, {c.u + 1, c.v + 1}, {c.u, c.v + 1}};
    std::optional<glm::dvec3> ends[4];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      if (corner[i] == corner[next]) continue;
      const bool forward = i < 2;
      ends[count++] = crossing(places[forward ? i : next], places[forward ? next : i]);
    }
    for (int i = 0; i + 1 < count; i += 2) add(*ends[i], *ends[i + 1]);
  }

  // Adds the part of a piece that lies on the other face itself.
  void add(glm::dvec3 a, glm::dvec3 b) {
    const double at_a = beyond(a), at_b = beyond(b);
    if (at_a > 0.0 && at_b > 0.0) return;
    if (at_a > 0.0) a += (b - a) * (at_a / (at_a - at_b));
    if (at_b > 0.0) b += (a - b) * (at_b / (at_b - at_a));
    if (glm::vec3(a) != glm::vec3(b)) found_.push_back({glm::vec3(a), glm::vec3(b)});
  }

  const ShapeFace& face_;
  const ShapeFace& other_;
  double touching_;
  std::vector<FaceCrossing> found_;
};

}  // namespace

std::vector<FaceCrossing> face_contours(const ShapeFace& face, const ShapeFace& other) {
  return Contours(face, other).find();
}

}  // namespace asos
