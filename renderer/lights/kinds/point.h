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
};

template <>
struct LightGeometry<LightShape::distant> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return cosine_above(light.towards, receiver);
  }
  static LightSample sample(const PreparedLight& light, const Receiver& receiver, double, double) {
    return {light.towards, infinitely_far, irradiance_of(light.power, form(light, receiver))};
  }
};

}  // namespace asos
