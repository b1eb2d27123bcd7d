#pragma once

#include "renderer/lights/kinds/flat.h"

namespace asos {

template <>
struct LightGeometry<LightShape::rectangle> : FlatGeometry<LightGeometry<LightShape::rectangle>> {
  static double physical_form(const PreparedLight& light, const Receiver& receiver, bool behind) {
    return outlines_form(light, receiver, behind);
  }

  static bool holds(const PreparedLight& light, glm::dvec3 p) {
    return SharedGeometry<LightShape::rectangle>::holds(light, p);
  }
  static LightOutlines outlines(const PreparedLight& light, std::optional<glm::dvec3>, glm::dvec3) {
    const glm::dvec3 p = light.position, u = light.half_u, v = light.half_v;
    return {{p - u - v, p + u - v, p + u + v, p - u + v}};
  }
  static void add_facing_patches(const PreparedLight& light, glm::dvec3 to_middle,
                                 std::vector<LightPatch>& patches) {
    LightPatch patch = centred_patch(light, to_middle, LightPatch::Kind::trapezoid);
    patch.left = patch.foot = -1.0f;
    patch.width = patch.height = 2.0f;
    patches.push_back(patch);
  }
  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3 apex) {
    return bounds(light, apex, LightWindow::Inside::all);
  }
};

}  // namespace asos
