#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/geometry.h"

namespace asos {

/// All directions about `towards` up to an angle whose tangent is `radius`.
template <>
struct LightGeometry<LightShape::sun> {
  static double sine(const PreparedLight& light) {
    return light.radius / std::sqrt(1.0 + light.radius * light.radius);
  }
  static double form(const PreparedLight& light, const Receiver& receiver) {
    if (light.rule == LightRule::published)
      return std::numbers::pi * light.radius * light.radius * cosine_above(light.towards, receiver);
    const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
    return cone_form(light.towards, light.radius * cosine, cosine, receiver);
  }
  static void add_patches(const PreparedLight& light, const Receiver&,
                          std::vector<LightPatch>& patches) {
    const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
    LightPatch::add_cap(light.towards, one_less_cosine(light.radius * cosine), patches);
  }
  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3) {
    return LightWindow::around_ball(light.towards, sine(light));
  }
};

}  // namespace asos
