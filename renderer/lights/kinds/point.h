#pragma once

#include "renderer/lights/kinds/geometry.h"

namespace asos {

template <>
struct LightGeometry<LightShape::point> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return point_form(light.position - receiver.position, receiver) *
           attenuation(light, receiver.position);
  }
  static LightSample sample(const PreparedLight& light, const Receiver& receiver, double, double) {
    LightSample sample = sample_towards(light.position - receiver.position);
    sample.irradiance = irradiance_of(light.power, form(light, receiver));
    return sample;
  }
  static Highlight highlight(const PreparedLight&, glm::dvec3 to_middle, glm::dvec3 ray) {
    return highlight_towards(to_middle, 0.0, ray);
  }
};

template <>
struct LightGeometry<LightShape::distant> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return cosine_above(light.towards, receiver);
  }
  static LightSample sample(const PreparedLight& light, const Receiver& receiver, double, double) {
    return {light.towards, infinitely_far, irradiance_of(light.power, form(light, receiver))};
  }
  static Highlight highlight(const PreparedLight& light, glm::dvec3, glm::dvec3) {
    return {glm::vec3(light.towards), 0.0f};
  }
};

}  // namespace asos
