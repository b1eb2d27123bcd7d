#pragma once

#include "renderer/lights/kinds/flat.h"

namespace asos {

template <>
struct LightGeometry<LightShape::polygon> : FlatGeometry<LightGeometry<LightShape::polygon>> {
  static double physical_form(const PreparedLight& light, const Receiver& receiver, bool behind) {
    return outlines_form(light, receiver, behind);
  }
  /// Returns whether the outlines wind around the point an odd number of times.
  static bool holds(const PreparedLight& light, glm::dvec3 p) {
    const glm::dvec3 u = light.u_axis, v = light.v_axis;
    const auto flat = [&](glm::dvec3 q) {
      const glm::dvec3 to = q - light.position - p;
      return glm::dvec2(glm::dot(to, u), glm::dot(to, v));
    };
    bool in = false;
    for (const auto& outline : light.outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = flat(outline[i]), b = flat(outline[(i + 1) % outline.size()]);
        if ((a.y > 0.0) != (b.y > 0.0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0.0) in = !in;
      }
    }
    return in;
  }

  static std::optional<SampledHit> sampled_hit(const PreparedLight& light, const Receiver& receiver,
                                               glm::dvec3 direction) {
    const auto t = meet(light, receiver.position, direction);
    if (!t) return std::nullopt;
    return SampledHit{*t, *t * *t / (light.area * std::abs(glm::dot(direction, light.towards)))};
  }

  static LightOutlines outlines(const PreparedLight& light, std::optional<glm::dvec3>, glm::dvec3) {
    return light.outlines;
  }

  static void add_facing_patches(const PreparedLight& light, glm::dvec3 to_middle,
                                 std::vector<LightPatch>& patches) {
    const double per_unit = 1.0 / glm::length(to_middle);
    LightPatch patch = centred_patch(light, to_middle, LightPatch::Kind::trapezoid);
    patch.x = glm::vec3(light.u_axis);
    patch.y = glm::vec3(light.v_axis);
    patch.facing = glm::vec3(light.towards);
    for (const PolygonRows::Row& row : light.rows.rows) {
      patch.foot = static_cast<float>(per_unit * row.y0);
      patch.height = static_cast<float>(per_unit * (row.y1 - row.y0));
      for (std::uint32_t i = row.first; i < row.first + row.count; ++i) {
        const PolygonRows::Trapezoid& t = light.rows.trapezoids[i];
        patch.left = static_cast<float>(per_unit * t.left0);
        patch.left_on = static_cast<float>(per_unit * (t.left1 - t.left0));
        patch.width = static_cast<float>(per_unit * (t.right0 - t.left0));
        patch.width_on = static_cast<float>(per_unit * (t.right1 - t.left1)) - patch.width;
        patches.push_back(patch);
      }
    }
  }

  static std::optional<LightWindow> window(const PreparedLight& light, glm::dvec3 apex) {
    return bounds(light, apex, LightWindow::Inside::outlines);
  }
};

}  // namespace asos
