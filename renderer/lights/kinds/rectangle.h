#pragma once

#include "renderer/lights/kinds/flat.h"
#include "renderer/lights/spherical_rectangle.h"

#include <array>

namespace asos {

template <>
struct LightGeometry<LightShape::rectangle> : FlatGeometry<LightGeometry<LightShape::rectangle>> {
  static double physical_form(const PreparedLight& light, const Receiver& receiver, bool behind) {
    return outlines_form(light, receiver, behind);
  }

  static LightSample sample(const PreparedLight& light, const Receiver& receiver, double u,
                            double v) {
    const glm::dvec3 middle = light.position - receiver.position;
    const double height = -glm::dot(middle, light.towards);
    if (light.faces(height)) {
      const std::array horizons{receiver.geometric, receiver.normal};
      const SphericalRectangle rectangle(middle, light.half_u, light.half_v, horizons);
      // Smaller solid angles have too few digits, and sampling by area is as good at that distance.
      constexpr double least = 1e-5;
      if (rectangle.solid_angle() > least) {
        LightSample sample = sample_towards(rectangle.point(u, v));
        const double form = rectangle.solid_angle() * cosine_above(sample.direction, receiver);
        sample.irradiance = irradiance_of(light.power, form);
        return sample;
      }
    }
    return area_sample(light, receiver,
                       middle + (2.0 * u - 1.0) * light.half_u + (2.0 * v - 1.0) * light.half_v);
  }

  static bool holds(const PreparedLight& light, glm::dvec3 p) {
    const glm::dvec3 d = p - light.position;
    return std::abs(glm::dot(d, light.half_u)) <= glm::dot(light.half_u, light.half_u) &&
           std::abs(glm::dot(d, light.half_v)) <= glm::dot(light.half_v, light.half_v);
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
