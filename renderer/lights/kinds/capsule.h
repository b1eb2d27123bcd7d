#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/ball.h"
#include "renderer/lights/seen_capsule.h"

#include <array>

namespace asos {

/// Directions to a capsule, uniform by solid angle: a longitude, then the sine of the latitude. The
/// part between the arcs has a closed form; on an arc, Newton's method finds the longitude.
class CapsuleDirections {
 public:
  explicit CapsuleDirections(const SeenCapsule& seen) : seen_(seen) {
    for (const std::size_t i : {0, 1}) {
      const SeenCapsule::End& end = seen.ends[i];
      const double far = std::hypot(end.along, seen.height * seen.cosine * seen.cosine);
      side_[i] = std::asin(seen.sine * (end.along / far));
      arc_[i] = area_to(end, std::atan2(end.cosine * std::sin(end.arc), std::cos(end.arc)));
    }
    all_ = arc_[0] + arc_[1] + (side_[1] - side_[0]);
  }

  [[nodiscard]] double solid_angle() const { return 2.0 * all_; }

  /// Returns a unit direction. Its density by solid angle is 1 / solid_angle().
  [[nodiscard]] glm::dvec3 direction(double u, double v) const {
    const double before = u * all_, behind = (1.0 - u) * all_;
    if (before < arc_[0]) return on_end(seen_.ends[0], before, v);
    if (behind < arc_[1]) return on_end(seen_.ends[1], behind, v);
    const double angle = std::min(side_[0] + (before - arc_[0]), side_[1]);
    const double sine = std::clamp(std::sin(angle) / seen_.sine, -1.0, 1.0);
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    const double widest = std::min(1.0, seen_.sine * cosine / std::cos(angle));
    return spread(cosine * seen_.foot + sine * seen_.along, widest, v);
  }

 private:
  // Areas are halves of solid angles: on one side of the plane through the axis.

  /// Returns the area between the tip of an end's arc and a longitude: the ball's half angle and
  /// the longitude from the ball's centre have sines in the ratio 1 to cos(angle).
  static double area_to(const SeenCapsule::End& end, double angle) {
    const double s = std::sin(angle), c = std::cos(angle), less = end.one_less_cosine();
    return less * std::atan2(s, c * end.cosine) -
           std::atan2(c * s * less, s * s + c * c * end.cosine);
  }
  /// Returns the inverse of area_to. The area grows with the cube of a small angle, so the
  /// iteration compares cube roots. Half of the ball is symmetrical to the other.
  static double angle_of(const SeenCapsule::End& end, double area) {
    const double whole = std::numbers::pi * end.one_less_cosine();
    if (area > 0.5 * whole) return std::numbers::pi - angle_of(end, std::max(0.0, whole - area));
    const double root = std::cbrt(area);
    double angle = 0.5 * std::cbrt(6.0 * std::numbers::pi * (area / whole));
    for (int i = 0; i < 4 && angle > 1e-4; ++i) {
      const double s = std::sin(angle), x = end.sine * std::cos(angle);
      const double slope = end.sine * end.sine * s * s / ((1.0 - x) * (1.0 + x));
      const double now = std::cbrt(std::max(0.0, area_to(end, angle)));
      angle -= (now - root) * 3.0 * now * now / slope;
    }
    return std::clamp(angle, 0.0, 0.5 * std::numbers::pi);
  }

  [[nodiscard]] glm::dvec3 on_end(const SeenCapsule::End& end, double area, double v) const {
    const double angle = angle_of(end, area);
    const double sine = end.sine * std::cos(angle);
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    return spread(cosine * end.axis + sine * end.outward, end.sine * std::sin(angle) / cosine, v);
  }
  [[nodiscard]] glm::dvec3 spread(glm::dvec3 flat, double widest, double v) const {
    const double sine = (2.0 * v - 1.0) * widest;
    return std::sqrt((1.0 - sine) * (1.0 + sine)) * flat + sine * seen_.across;
  }

  SeenCapsule seen_;
  std::array<double, 2> side_{}, arc_{};  // areas: from the foot to the arc, and within it
  double all_ = 0.0;
};

/// Within the infinite cylinder around a capsule, all of it but one ball is hidden.
template <>
struct LightGeometry<LightShape::capsule> {
  using Ball = LightGeometry<LightShape::ball>;

  static std::optional<SeenCapsule> seen(const PreparedLight& light, glm::dvec3 position) {
    return SeenCapsule::of(light.position - position, light.half_u, light.radius);
  }
  static PreparedLight nearest_ball(const PreparedLight& light, glm::dvec3 position) {
    PreparedLight ball = light;
    ball.position =
        position + SeenCapsule::nearest_of_axis(light.position - position, light.half_u);
    return ball;
  }

  static double form(const PreparedLight& light, const Receiver& receiver) {
    const glm::dvec3 begin = light.position - light.half_u, end = light.position + light.half_u;
    if (light.rule == LightRule::physical) return capsule_form(begin, end, light.radius, receiver);
    return light.area / (2.0 * glm::length(light.half_u)) * line_form(begin, end, false, receiver);
  }

  /// First to third: the sample relative to the receiver. Fourth: its form.
  static glm::dvec4 numbers(const PreparedLight& light, const Receiver& receiver, double u,
                            double v) {
    const auto at = seen(light, receiver.position);
    if (!at) {
      const PreparedLight ball = nearest_ball(light, receiver.position);
      const auto sample = SharedGeometry<LightShape::ball>::sample(
          SampleQuery<LightShape::ball>{ball, receiver, {u, v}});
      return {sample.distance * sample.direction, sample.form};
    }
    const CapsuleDirections directions(*at);
    const glm::dvec3 direction = directions.direction(u, v);
    const double distance = entry(light, light.position - receiver.position, direction).distance;
    return {distance * direction, directions.solid_angle() * cosine_above(direction, receiver)};
  }

  static std::optional<SampledHit> sampled_hit(const PreparedLight& light, const Receiver& receiver,
                                               glm::dvec3 direction) {
    const glm::dvec3 to_middle = light.position - receiver.position;
    const Entry at = entry(light, to_middle, direction);
    const glm::dvec3 to_ball = SeenCapsule::nearest_of_axis(to_middle, light.half_u);
    const double distance = glm::length(to_ball);
    if (distance <= light.radius) {
      const double cosine = std::max(0.0, glm::dot(direction, receiver.normal));
      return SampledHit{
          2.0 * glm::dot(direction, to_ball) - into_ball(to_ball, light.radius, direction).distance,
          cosine * std::numbers::inv_pi};
    }
    if (!at.met || !(at.distance > 0.0)) return std::nullopt;
    if (const auto outside = seen(light, receiver.position))
      return SampledHit{at.distance, 1.0 / CapsuleDirections(*outside).solid_angle()};
    const double one_less = one_less_cosine(light.radius / distance);
    return SampledHit{at.distance, 0.5 * std::numbers::inv_pi / one_less};
  }

  /// The silhouette in the plane of the window, as trapezoids between its corners.
  static void add_patches(const PreparedLight& light, const Receiver& receiver,
                          std::vector<LightPatch>& patches) {
    constexpr int sides = 24;
    const auto at = seen(light, receiver.position);
    if (!at) return Ball::add_patches(nearest_ball(light, receiver.position), receiver, patches);
    const LightWindow around = window_of(*at, sides);
    const double per_unit = 1.0 / glm::length(light.position - receiver.position);
    const glm::dvec3 x = per_unit * glm::normalize(around.half_v);
    const glm::dvec3 y = per_unit * glm::normalize(around.half_u);
    LightPatch patch;
    patch.origin = glm::vec3(per_unit * around.middle);
    patch.x = glm::vec3(x);
    patch.y = glm::vec3(y);
    const glm::dvec3 facing = glm::cross(x, y);
    patch.facing = glm::vec3(glm::dot(facing, around.middle) < 0.0 ? facing : -facing);
    const auto corner = [&](std::size_t i) {
      const glm::dvec3 p = around.outline[i] - around.middle;
      return glm::dvec2(glm::dot(p, glm::normalize(around.half_v)),
                        glm::dot(p, glm::normalize(around.half_u)));
    };
    // The outline runs around the axis' end first; its halves are symmetrical.
    const auto first = static_cast<std::size_t>(at->half_sides(sides)[1]);
    for (std::size_t i = first; i < first + sides / 2 + 1; ++i) {
      const glm::dvec2 high = corner(i), low = corner(i + 1);
      patch.foot = static_cast<float>(low.y);
      patch.height = static_cast<float>(high.y - low.y);
      patch.left = static_cast<float>(-std::abs(low.x));
      patch.width = -2.0f * patch.left;
      patch.left_on = static_cast<float>(std::abs(low.x) - std::abs(high.x));
      patch.width_on = -2.0f * patch.left_on;
      patches.push_back(patch);
    }
  }

  static std::optional<double> meet(const PreparedLight& light, glm::dvec3 origin,
                                    glm::dvec3 direction) {
    const Entry at = entry(light, light.position - origin, direction);
    return at.met ? std::optional(at.distance) : std::nullopt;
  }

  static LightOutlines outlines(const PreparedLight& light, std::optional<glm::dvec3> apex,
                                glm::dvec3 direction) {
    // From infinity, the silhouette is nearly the one from this distance, in sizes of the light.
    constexpr double far = 1e6;
    const double size = glm::length(light.half_u) + light.radius;
    const glm::dvec3 from = apex.value_or(light.position - far * size * direction);
    const auto at = seen(light, from);
    if (!at) return Ball::outlines(nearest_ball(light, from), from, direction);
    std::vector<glm::dvec3> outline = outline_of(*at, circle_points);
    for (glm::dvec3& p : outline) p += from;
    return {std::move(outline)};
  }

  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3 apex) {
    constexpr int sides = 12;
    if (const auto at = seen(light, apex)) return window_of(*at, sides);
    return Ball::window(nearest_ball(light, apex), apex);
  }

  static double way(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards) {
    const double length = glm::length(towards);
    return entry(light, light.position - from, towards / length).distance / length;
  }

 private:
  /// Where a ray enters, and whether it does; otherwise the distance is about that of its nearest
  /// point.
  struct Entry {
    double distance = 0.0;
    bool met = false;
  };
  static Entry into_ball(glm::dvec3 to_centre, double radius, glm::dvec3 direction) {
    const double along = glm::dot(to_centre, direction);
    const glm::dvec3 beside = to_centre - along * direction;
    const double under = radius * radius - glm::dot(beside, beside);
    return {along - std::sqrt(std::max(0.0, under)), under > 0.0};
  }
  static Entry entry(const PreparedLight& light, glm::dvec3 to_middle, glm::dvec3 direction) {
    const double half = glm::length(light.half_u);
    const glm::dvec3 axis = light.half_u / half;
    const double slope = glm::dot(direction, axis);
    // Look for the ray's entry into the infinite cylinder.
    const glm::dvec3 flat = direction - slope * axis;
    const glm::dvec3 foot = to_middle - glm::dot(to_middle, axis) * axis;
    const double flat2 = glm::dot(flat, flat);
    const glm::dvec3 steep_end = to_middle + (slope > 0.0 ? -1.0 : 1.0) * light.half_u;
    if (!(flat2 > 1e-20)) return into_ball(steep_end, light.radius, direction);
    const double nearest = glm::dot(foot, flat) / flat2;
    const glm::dvec3 beside = foot - nearest * flat;
    const double under = light.radius * light.radius - glm::dot(beside, beside);
    const double distance = nearest - std::sqrt(std::max(0.0, under) / flat2);
    const double place = distance * slope - glm::dot(to_middle, axis);
    if (std::abs(place) <= half) return {distance, under > 0.0};
    return into_ball(to_middle + (place > 0.0 ? 1.0 : -1.0) * light.half_u, light.radius,
                     direction);
  }

  static std::vector<glm::dvec3> outline_of(const SeenCapsule& seen, int sides) {
    auto [begin, end] = seen.silhouette(seen.half_sides(sides));
    end.insert(end.end(), begin.rbegin(), begin.rend());
    return std::move(end);
  }

  /// The window stands on the line between the silhouette's tips. It is moved away until nothing of
  /// the silhouette is behind it.
  static LightWindow window_of(const SeenCapsule& seen, int sides) {
    const glm::dvec3 begin = seen.on_arc(seen.ends[0], 0.0), end = seen.on_arc(seen.ends[1], 0.0);
    const glm::dvec3 u = glm::normalize(end - begin);
    const glm::dvec3 away = glm::cross(u, seen.across);
    LightWindow window{{}, {}, {}, LightWindow::Inside::silhouette, outline_of(seen, sides)};
    double distance = 0.0;
    for (const glm::dvec3& p : window.outline) distance = std::max(distance, glm::dot(away, p));
    double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0.0;
    for (glm::dvec3& p : window.outline) {
      p *= distance / glm::dot(away, p);
      low = std::min(low, glm::dot(p, u));
      high = std::max(high, glm::dot(p, u));
      widest = std::max(widest, std::abs(glm::dot(p, seen.across)));
    }
    window.middle = distance * away + 0.5 * (low + high) * u;
    window.half_u = 0.5 * (high - low) * u;
    window.half_v = widest * seen.across;
    return window;
  }
};

}  // namespace asos
