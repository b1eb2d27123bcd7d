#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/geometry.h"

namespace asos {

template <>
struct LightGeometry<LightShape::ball> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    const double shown = attenuation(light, receiver.position);
    if (light.rule == LightRule::physical)
      return ball_form(light.position, light.radius, receiver) * shown;
    return std::numbers::pi * light.radius * light.radius *
           point_form(light.position - receiver.position, receiver) * shown;
  }

  static void add_patches(const PreparedLight& light, const Receiver& receiver,
                          std::vector<LightPatch>& patches) {
    const glm::dvec3 to_middle = light.position - receiver.position;
    const double distance = glm::length(to_middle);
    if (distance > light.radius) {
      LightPatch::add_cap(to_middle / distance, one_less_cosine(light.radius / distance), patches);
    } else {
      LightPatch::add_cap(receiver.normal, 1.0, patches);
    }
  }

  static std::optional<double> meet(const PreparedLight& light, glm::dvec3 origin,
                                    glm::dvec3 direction) {
    const glm::dvec3 to_middle = light.position - origin;
    const double along = glm::dot(to_middle, direction);
    const double under =
        light.radius * light.radius - glm::dot(to_middle, to_middle) + along * along;
    // From inside, the ball is invisible.
    if (!(under > 0.0)) return std::nullopt;
    return along - std::sqrt(under);
  }

  /// Returns the circle in which the cone from the apex touches the ball.
  static LightOutlines outlines(const PreparedLight& light, std::optional<glm::dvec3> apex,
                                glm::dvec3 direction) {
    const glm::dvec3 to_middle = apex ? light.position - *apex : direction;
    const double distance = glm::length(to_middle);
    const glm::dvec3 axis = to_middle / distance;
    double back = 0.0, radius = light.radius;
    if (apex) {
      if (!(distance > light.radius)) return {};
      back = light.radius * light.radius / distance;
      radius = light.radius * std::sqrt(1.0 - back / distance);
    }
    const glm::dvec3 u = glm::normalize(
        glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    return {circle_outline(light.position - back * axis, radius * u, radius * glm::cross(axis, u))};
  }

  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3 apex) {
    return LightWindow::around_ball(light.position - apex, light.radius);
  }

  static double way(const PreparedLight& light, glm::dvec3 from, glm::dvec3 towards) {
    const glm::dvec3 to_middle = light.position - from;
    const double length2 = glm::dot(towards, towards);
    const double along = glm::dot(to_middle, towards) / length2;
    const glm::dvec3 beside = to_middle - along * towards;
    const double within2 = light.radius * light.radius - glm::dot(beside, beside);
    return along - std::sqrt(std::max(0.0, within2) / length2);
  }
};

}  // namespace asos
