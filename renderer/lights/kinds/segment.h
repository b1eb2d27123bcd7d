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
};

}  // namespace asos
