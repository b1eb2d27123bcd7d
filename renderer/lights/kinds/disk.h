#pragma once

#include "renderer/lights/kinds/flat.h"

namespace asos {

template <>
struct LightGeometry<LightShape::disk> : FlatGeometry<LightGeometry<LightShape::disk>> {
  static double physical_form(const PreparedLight& light, const Receiver& receiver, bool behind) {
    return disk_form(light.position, behind ? -light.towards : light.towards, light.radius,
                     receiver);
  }
  static bool holds(const PreparedLight& light, glm::dvec3 p) {
    return SharedGeometry<LightShape::disk>::holds(light, p);
  }
  static LightOutlines outlines(const PreparedLight& light, std::optional<glm::dvec3>, glm::dvec3) {
    return {circle_outline(light.position, light.half_u, light.half_v)};
  }
  static void add_facing_patches(const PreparedLight& light, glm::dvec3 to_middle,
                                 std::vector<LightPatch>& patches) {
    LightPatch::add_quarters(centred_patch(light, to_middle, LightPatch::Kind::sector), patches);
  }
  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3 apex) {
    return bounds(light, apex, LightWindow::Inside::ellipse);
  }
};

}  // namespace asos
