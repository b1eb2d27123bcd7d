#pragma once

#include "renderer/lights/kinds/geometry.h"

namespace asos {

template <>
struct LightGeometry<LightShape::point> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return point_form(light.position - receiver.position, receiver) *
           attenuation(light, receiver.position);
  }
};

template <>
struct LightGeometry<LightShape::distant> {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    return cosine_above(light.towards, receiver);
  }
};

}  // namespace asos
