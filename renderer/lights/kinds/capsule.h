#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/ball.h"
#include "renderer/lights/seen_capsule.h"

#include <array>

namespace asos {

/// Within the infinite cylinder around a capsule, all of it but one ball is hidden.
template <>
struct LightGeometry<LightShape::capsule> {
  using Ball = LightGeometry<LightShape::ball>;
  using Shared = SharedGeometry<LightShape::capsule>;

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

  /// As SharedGeometry's, from inside the infinite cylinder, too.
  static glm::dvec4 numbers(const PreparedLight& light, const Receiver& receiver, double u,
                            double v) {
    const auto found = Shared::numbers(light, receiver, light.position - receiver.position, u, v);
    if (!(found.fourth < 0.0)) return {found.first, found.second, found.third, found.fourth};
    using BallQuery = SampleQuery<LightShape::ball>;
    const PreparedLight ball = nearest_ball(light, receiver.position);
    const auto sample = SharedGeometry<LightShape::ball>::sample(BallQuery{ball, receiver, {u, v}});
    return {sample.distance * sample.direction, sample.form};
  }

  static std::optional<SampledHit> sampled_hit(const PreparedLight& light, const Receiver& receiver,
                                               glm::dvec3 direction) {
    const glm::dvec3 to_middle = light.position - receiver.position;
    const auto at = Shared::entry(light, to_middle, direction);
    const glm::dvec3 to_ball = SeenCapsule::nearest_of_axis(to_middle, light.half_u);
    const double distance = glm::length(to_ball);
    if (distance <= light.radius) {
      const double cosine = std::max(0.0, glm::dot(direction, receiver.normal));
      return SampledHit{2.0 * glm::dot(direction, to_ball) -
                            entry_into_ball(to_ball, light.radius, direction).distance,
                        cosine * std::numbers::inv_pi};
    }
    if (!at.met || !(at.distance > 0.0)) return std::nullopt;
    if (const auto outside = seen(light, receiver.position))
      return SampledHit{at.distance, 1.0 / CapsuleDirections<glm::dvec3>(*outside).solid_angle()};
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
    const auto at = Shared::entry(light, light.position - origin, direction);
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
    return Shared::entry(light, light.position - from, towards / length).distance / length;
  }

 private:
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
