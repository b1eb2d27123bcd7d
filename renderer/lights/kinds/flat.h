#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/kinds/geometry.h"

namespace asos {

/// Shared by the shapes in a plane. `Shape` has `physical_form`, `holds` (a point of the plane)
/// and `add_facing_patches`.
template <typename Shape>
struct FlatGeometry {
  static double form(const PreparedLight& light, const Receiver& receiver) {
    if (light.rule == LightRule::published) return middle_form(light, receiver);
    const double height = glm::dot(receiver.position - light.position, light.towards);
    return light.faces(height) ? Shape::physical_form(light, receiver, height < 0.0) : 0.0;
  }

  static void add_patches(const PreparedLight& light, const Receiver& receiver,
                          std::vector<LightPatch>& patches) {
    const glm::dvec3 to_middle = light.position - receiver.position;
    if (!(glm::length(to_middle) > 0.0)) return;
    const double height = -glm::dot(to_middle, light.towards);
    if (height == 0.0 || (height < 0.0 && !light.two_sided)) return;
    Shape::add_facing_patches(light, to_middle, patches);
  }

  static std::optional<double> meet(const PreparedLight& light, glm::dvec3 origin,
                                    glm::dvec3 direction) {
    const double slope = glm::dot(direction, light.towards);
    if (slope == 0.0 || (slope > 0.0 && !light.two_sided)) return std::nullopt;
    const double t = glm::dot(light.position - origin, light.towards) / slope;
    if (!(t > 0.0) || !Shape::holds(light, origin + t * direction - light.position))
      return std::nullopt;
    return t;
  }

 protected:
  static double outlines_form(const PreparedLight& light, const Receiver& receiver, bool behind) {
    double form = 0.0;
    for (const std::vector<glm::dvec3>& outline : light.outlines)
      form += polygon_form(outline, receiver);
    return std::max(0.0, behind ? -form : form);
  }

  /// Returns a patch with the light's centre, in units of its distance.
  static LightPatch centred_patch(const PreparedLight& light, glm::dvec3 to_middle,
                                  LightPatch::Kind kind) {
    const double per_unit = 1.0 / glm::length(to_middle);
    LightPatch patch;
    patch.kind = kind;
    patch.origin = glm::vec3(per_unit * to_middle);
    patch.two_sided = light.two_sided;
    patch.x = glm::vec3(per_unit * light.half_u);
    patch.y = glm::vec3(per_unit * light.half_v);
    patch.facing = glm::vec3(per_unit * per_unit * glm::cross(light.half_u, light.half_v));
    return patch;
  }

  static LightWindow bounds(const PreparedLight& light, glm::dvec3 apex,
                            LightWindow::Inside inside) {
    return {light.position - apex, light.half_u, light.half_v, inside, {}};
  }

 private:
  /// The published rule: the whole light at its centre, with the cosine there.
  static double middle_form(const PreparedLight& light, const Receiver& receiver) {
    const glm::dvec3 to_light = light.position - receiver.position;
    const double distance = glm::length(to_light);
    if (!(distance > 0.0)) return 0.0;
    const double cosine = -glm::dot(to_light, light.towards) / distance;
    const double seen = light.two_sided ? std::abs(cosine) : std::max(0.0, cosine);
    return light.area * seen * point_form(to_light, receiver);
  }
};

}  // namespace asos
