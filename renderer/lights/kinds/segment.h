#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/geometry.h"

namespace asos {

template <>
struct LightGeometry<LightShape::segment> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return part_form(light, receiver, -1.0, 1.0);
  }
  static double part_form(const PreparedLight& light, const Receiver& receiver, double t0,
                          double t1) {
    return line_form(light.position + t0 * light.half_u, light.position + t1 * light.half_u,
                     light.rule == LightRule::physical, receiver);
  }

  /// Samples by the angle at the receiver (Kulla and Fajardo 2012, "equi-angular"), which cancels
  /// the squared distance.
  static LightSample sample(const PreparedLight& light, const Receiver& receiver, double u,
                            double) {
    const glm::dvec3 to_middle = light.position - receiver.position;
    const double half = glm::length(light.half_u);
    const glm::dvec3 along = light.half_u / half;
    const double s0 = glm::dot(to_middle, along) - half;
    const double s1 = s0 + 2.0 * half;
    const glm::dvec3 foot = to_middle - glm::dot(to_middle, along) * along;
    const double height = glm::length(foot);
    const double angle = std::atan2(height * 2.0 * half, height * height + s0 * s1);

    double s = s0 + 2.0 * half * u;
    double measure = 2.0 * half;  // ds / du
    if (angle > 1e-4) {
      s = std::clamp(height * std::tan(std::atan2(s0, height) + u * angle), s0, s1);
      measure = angle / height * (height * height + s * s);
    }
    LightSample sample = sample_towards(foot + s * along);
    if (!(sample.distance > 0.0)) return sample;
    const double sine = light.rule == LightRule::physical ? height / sample.distance : 1.0;
    const double form = measure * sine * cosine_above(sample.direction, receiver) /
                        (sample.distance * sample.distance);
    sample.irradiance = irradiance_of(light.power, form);
    return sample;
  }
};

}  // namespace asos
