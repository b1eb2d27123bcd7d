#include "renderer/lights/form_factor.h"
#include "renderer/lights/light_math.h"
#include "renderer/lights/seen_capsule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

// Disks, balls and capsules. The contour integral along a circle (Lambert 1760) has a closed form.
// So a disk is one or two arcs of its rim, and straight sides along the horizons that cut it.

namespace asos {
namespace {

using std::numbers::pi;

/// The circle centre + radius (cos(angle) u + sin(angle) v) relative to a receiver on the side to
/// which `facing` = u x v points. The centre is aside u - height facing, with aside >= 0 and height
/// > 0. The squared distance to the circle is mean + swing cos(angle).
struct Circle {
  glm::dvec3 centre, facing, u, v;
  double radius, aside, height;
  double mean, swing, nearest2;  ///< nearest2 = mean - swing
  double root;                   ///< sqrt(mean^2 - swing^2)

  [[nodiscard]] glm::dvec3 at(double angle) const {
    return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
};

Circle make_circle(glm::dvec3 centre, glm::dvec3 facing, double radius) {
  Circle circle;
  circle.centre = centre;
  circle.facing = facing;
  circle.radius = radius;
  circle.height = -glm::dot(centre, facing);
  const glm::dvec3 sideways = centre + circle.height * facing;
  const double length = glm::length(sideways);
  if (length > 1e-9 * glm::length(centre)) {
    // Orthogonalize once more: the first time leaves the rounding error of a much longer vector.
    circle.u = sideways / length;
    circle.u = glm::normalize(circle.u - glm::dot(circle.u, facing) * facing);
  } else {
    circle.u = any_perpendicular(facing);
  }
  circle.v = glm::cross(facing, circle.u);
  circle.aside = std::max(0.0, glm::dot(centre, circle.u));
  const double near = circle.aside - radius;
  const double far = circle.aside + radius;
  const double height2 = circle.height * circle.height;
  circle.mean = circle.aside * circle.aside + height2 + radius * radius;
  circle.swing = 2.0 * radius * circle.aside;
  circle.nearest2 = near * near + height2;
  circle.root = std::sqrt(circle.nearest2) * std::sqrt(far * far + height2);
  return circle;
}

/// Returns the form of a disk that is wholly above the horizons: Lambert's vector irradiance, along
/// the disk's axis and across it (the configuration factors from a small element to a parallel and
/// to a perpendicular disk, Hamilton and Morgan 1952). The formula has no differences of nearly
/// equal numbers.
double whole_form(const Circle& c, glm::dvec3 normal) {
  const double radius2 = c.radius * c.radius;
  const double difference = c.aside * c.aside + c.height * c.height - radius2;
  const double along =
      difference > 0.0 ? 2.0 * pi * radius2 * c.height * c.height / (c.root * (c.root + difference))
                       : 0.5 * pi * (c.root - difference) / c.root;
  const double across = 2.0 * pi * c.height * radius2 * c.aside / ((c.mean + c.root) * c.root);
  return across * glm::dot(c.u, normal) - along * glm::dot(c.facing, normal);
}

/// atan(x) / x and log(1 + x) / x, also at 0.
double atan_over(double x) {
  return x == 0.0 ? 1.0 : std::atan(x) / x;
}
double log1p_over(double x) {
  return x == 0.0 ? 1.0 : std::log1p(x) / x;
}

/// Returns the contour integral along the rim from one angle to a larger one. With the point p of
/// the rim, it is the integral of -normal . (p x dp) / (2 p^2), which has the form (a + b cos + c
/// sin) / (mean + swing cos).
double arc_side(const Circle& c, double begin, double end, glm::dvec3 normal) {
  const double q = c.swing / (c.mean + c.root);
  const double one_less_q = (c.nearest2 + c.root) / (c.mean + c.root);
  // As for an orbit of eccentricity swing / mean: half the difference of the true and the eccentric
  // anomaly is atan(swing * lag). This keeps the integrals exact for a circle about the axis, too.
  const auto lag = [&](double angle) {
    const double half_cos = std::cos(0.5 * angle);
    return std::sin(angle) / ((c.mean + c.root) * (one_less_q + 2.0 * q * half_cos * half_cos));
  };
  const double lag_begin = lag(begin);
  const double lag_end = lag(end);
  const double anomaly_over_swing =
      2.0 * (lag_end * atan_over(c.swing * lag_end) - lag_begin * atan_over(c.swing * lag_begin));
  const double angle = end - begin;
  const double of_one = (angle - c.swing * anomaly_over_swing) / c.root;
  const double of_cos = (c.mean * anomaly_over_swing - q * angle) / c.root;
  const double half_cos = std::cos(0.5 * begin);
  const double begin_distance2 = c.nearest2 + 2.0 * c.swing * half_cos * half_cos;
  const double rise = (std::cos(end) - std::cos(begin)) / begin_distance2;
  const double of_sin = -rise * log1p_over(c.swing * rise);

  const double n_facing = glm::dot(normal, c.facing);
  const double n_u = glm::dot(normal, c.u);
  const double n_v = glm::dot(normal, c.v);
  return -0.5 * c.radius *
         (c.radius * n_facing * of_one + (c.aside * n_facing + c.height * n_u) * of_cos +
          c.height * n_v * of_sin);
}

/// The part of the rim above a horizon: from `begin` on over `length`, 0 to 2 pi.
struct Arc {
  double begin = 0.0;
  double length = 0.0;
};

Arc arc_above(const Circle& c, glm::dvec3 normal) {
  const double middle = glm::dot(normal, c.centre);
  const double n_u = c.radius * glm::dot(normal, c.u);
  const double n_v = c.radius * glm::dot(normal, c.v);
  const double swing = std::sqrt(n_u * n_u + n_v * n_v);
  if (middle >= swing) return {0.0, 2.0 * pi};
  if (middle <= -swing) return {0.0, 0.0};
  const double half = std::atan2(std::sqrt((swing - middle) * (swing + middle)), -middle);
  return {std::atan2(n_v, n_u) - half, 2.0 * half};
}

/// Returns the form of a disk cut by one horizon: an arc and its chord.
double segment_form(const Circle& c, const Arc& arc, glm::dvec3 normal) {
  const double end = arc.begin + arc.length;
  return arc_side(c, arc.begin, end, normal) + contour_side(c.at(end), c.at(arc.begin), normal);
}

/// Returns the corner of both horizons. `from` and `to` lie on one horizon's chord; `from` is above
/// the other horizon and `to` is below.
glm::dvec3 corner_of_horizons(glm::dvec3 from, glm::dvec3 to, glm::dvec3 other_normal) {
  const double above = std::max(0.0, glm::dot(from, other_normal));
  const double below = std::max(0.0, -glm::dot(to, other_normal));
  if (!(above > 0.0)) return from;
  return from + (to - from) * (above / (above + below));
}

/// Returns the form of a disk cut by both horizons: the arcs above both, each closed along the
/// horizon. Where an arc is entered across one horizon and left across the other, these meet in a
/// corner. Two arcs are a strip, whose chords each lie on one horizon.
double wedge_form(const Circle& c, const Arc& first, const Arc& second, const Receiver& receiver) {
  const glm::dvec3 normal = receiver.normal;
  const double first_end = first.length;
  const double second_begin =
      std::remainder(second.begin - first.begin - pi, 2.0 * pi) + pi;  // 0 to 2 pi
  const double second_end = second_begin + second.length;
  const bool late = second_begin < first_end;
  const bool early = second_end > 2.0 * pi;
  const auto arc = [&](double begin, double end) {
    return arc_side(c, first.begin + begin, first.begin + end, normal);
  };
  const auto side = [&](double from, double to) {
    return contour_side(c.at(first.begin + from), c.at(first.begin + to), normal);
  };
  if (late && early) {
    const double left = second_end - 2.0 * pi;
    return arc(0.0, left) + side(left, second_begin) + arc(second_begin, first_end) +
           side(first_end, 0.0);
  }
  if (!late && !early) return 0.0;
  // The later arc begins on the second horizon, the earlier one on the first.
  const double begin = late ? second_begin : 0.0;
  const double second_limit = late ? second_end : second_end - 2.0 * pi;
  const bool ends_on_first = first_end < second_limit;
  const double end = std::min(first_end, second_limit);
  if (ends_on_first != late) return arc(begin, end) + side(end, begin);
  const glm::dvec3 from = c.at(first.begin + end);
  const glm::dvec3 to = c.at(first.begin + begin);
  const glm::dvec3 corner =
      ends_on_first ? corner_of_horizons(from, c.at(first.begin), receiver.geometric)
                    : corner_of_horizons(from, c.at(first.begin + second_begin), receiver.normal);
  return arc(begin, end) + contour_side(from, corner, normal) + contour_side(corner, to, normal);
}

double circle_form(const Circle& circle, const Receiver& receiver) {
  const Arc by_normal = arc_above(circle, receiver.normal);
  const Arc by_geometric = arc_above(circle, receiver.geometric);
  if (by_normal.length == 0.0 || by_geometric.length == 0.0) return 0.0;
  const bool normal_cuts = by_normal.length < 2.0 * pi;
  const bool geometric_cuts = by_geometric.length < 2.0 * pi;
  double form = 0.0;
  if (!normal_cuts && !geometric_cuts) {
    form = whole_form(circle, receiver.normal);
  } else if (!geometric_cuts) {
    form = segment_form(circle, by_normal, receiver.normal);
  } else if (!normal_cuts) {
    form = segment_form(circle, by_geometric, receiver.normal);
  } else {
    form = wedge_form(circle, by_normal, by_geometric, receiver);
  }
  return std::max(0.0, form);  // the sum of an arc and a chord rounds to either side of 0
}

/// Returns the circle about `axis` in which a cone cuts the unit sphere.
Circle cone_circle(glm::dvec3 axis, glm::dvec3 u, double sine, double cosine) {
  Circle circle;
  circle.centre = cosine * axis;
  circle.facing = -axis;
  circle.u = u;
  circle.v = glm::cross(circle.facing, circle.u);
  circle.radius = sine;
  circle.aside = 0.0;
  circle.height = cosine;
  circle.swing = 0.0;
  circle.mean = circle.nearest2 = circle.root = 1.0;
  return circle;
}

/// A closed outline of straight sides and arcs around a convex region, counter-clockwise.
class ArcOutline {
 public:
  void add_arc(const Circle& circle, double begin, double end) {
    join(circle.at(begin));
    edges_[count_++] = {circle.at(begin), circle.at(end), &circle, begin, end};
  }
  void add_side(glm::dvec3 from, glm::dvec3 to) {
    join(from);
    edges_[count_++] = {from, to};
  }
  void close() {
    if (count_ > 0) join(edges_[0].from);
  }

  /// Returns the part above a horizon. The gap where the outline is below it becomes a side.
  [[nodiscard]] ArcOutline above(glm::dvec3 normal) const {
    ArcOutline kept;
    for (const Edge& edge : std::span(edges_).first(count_)) {
      if (edge.circle) {
        kept.add_above(edge, normal);
      } else {
        kept.add_side_above(edge.from, edge.to, normal);
      }
    }
    kept.close();
    return kept;
  }
  [[nodiscard]] double form(glm::dvec3 normal) const {
    double sum = 0.0;
    for (const Edge& edge : std::span(edges_).first(count_)) {
      sum += edge.circle ? arc_side(*edge.circle, edge.begin, edge.end, normal)
                         : contour_side(edge.from, edge.to, normal);
    }
    return sum;
  }

 private:
  struct Edge {
    glm::dvec3 from{0.0}, to{0.0};
    const Circle* circle = nullptr;  // of an arc
    double begin = 0.0, end = 0.0;
  };

  void join(glm::dvec3 next) {
    if (count_ == 0 || edges_[count_ - 1].to == next) return;
    const glm::dvec3 from = edges_[count_ - 1].to;
    edges_[count_++] = {from, next};
  }
  void add_side_above(glm::dvec3 from, glm::dvec3 to, glm::dvec3 normal) {
    const double begin = glm::dot(normal, from), end = glm::dot(normal, to);
    if (!(begin > 0.0) && !(end > 0.0)) return;
    const auto crossing = [&] { return from + (to - from) * (begin / (begin - end)); };
    add_side(begin > 0.0 ? from : crossing(), end > 0.0 ? to : crossing());
  }
  void add_above(const Edge& edge, glm::dvec3 normal) {
    const Arc arc = arc_above(*edge.circle, normal);
    if (arc.length == 2.0 * pi) return add_arc(*edge.circle, edge.begin, edge.end);
    // The arc above the horizon may cover both ends of the edge, but not its middle.
    const double first = edge.begin + std::remainder(arc.begin - edge.begin - pi, 2.0 * pi) + pi;
    for (const double begin : {first - 2.0 * pi, first}) {
      const double low = std::max(edge.begin, begin);
      const double high = std::min(edge.end, begin + arc.length);
      if (low < high) add_arc(*edge.circle, low, high);
    }
  }

  // Two arcs and two sides; each horizon cuts up to two edges, and each part may be joined.
  std::array<Edge, 24> edges_;
  std::size_t count_ = 0;
};

}  // namespace

double capsule_form(glm::dvec3 begin, glm::dvec3 end, double radius, const Receiver& receiver) {
  const glm::dvec3 to_middle = 0.5 * (begin + end) - receiver.position;
  const auto seen = SeenCapsule::of(to_middle, 0.5 * (end - begin), radius);
  if (!seen) {
    const glm::dvec3 nearest = SeenCapsule::nearest_of_axis(to_middle, 0.5 * (end - begin));
    return ball_form(receiver.position + nearest, radius, receiver);
  }
  const auto circle = [](const SeenCapsule::End& at) {
    return cone_circle(at.axis, at.outward, at.sine, at.cosine);
  };
  const std::array circles{circle(seen->ends[0]), circle(seen->ends[1])};
  ArcOutline outline;
  for (const std::size_t i : {1, 0})
    outline.add_arc(circles[i], -seen->ends[i].arc, seen->ends[i].arc);
  outline.close();
  const ArcOutline above = outline.above(receiver.normal).above(receiver.geometric);
  return std::max(0.0, above.form(receiver.normal));
}

double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius, const Receiver& receiver) {
  const Circle circle = make_circle(centre - receiver.position, facing, radius);
  if (!(circle.height > 0.0) || !(radius > 0.0) || !(circle.root > 0.0)) return 0.0;
  return circle_form(circle, receiver);
}

double disk_form(glm::dvec3 centre, glm::dvec3 facing, double radius, glm::dvec3 normal) {
  return disk_form(centre, facing, radius, Receiver{glm::dvec3(0.0), normal, normal});
}

double cone_form(glm::dvec3 axis, double sine, double cosine, const Receiver& receiver) {
  return circle_form(cone_circle(axis, any_perpendicular(axis), sine, cosine), receiver);
}

double ball_form(glm::dvec3 centre, double radius, const Receiver& receiver) {
  const glm::dvec3 to_centre = centre - receiver.position;
  const double distance = glm::length(to_centre);
  if (!(radius > 0.0)) return 0.0;
  if (distance <= radius) return 0.5 * pi * (1.0 + glm::dot(receiver.normal, receiver.geometric));
  const double cosine =
      std::sqrt((distance - radius) / distance) * std::sqrt((distance + radius) / distance);
  return cone_form(to_centre / distance, radius / distance, cosine, receiver);
}

double ball_form(glm::dvec3 centre, double radius, glm::dvec3 normal) {
  return ball_form(centre, radius, Receiver{glm::dvec3(0.0), normal, normal});
}

}  // namespace asos
