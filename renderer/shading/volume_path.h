#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace asos {

/// Where a ray is among the volumes that surfaces bound (KHR_materials_volume). Volumes within each
/// other are not told apart: a ray is in the one whose boundary it passed last, or in none.
struct VolumePath {
  static constexpr std::uint32_t nothing = 0xffffffffu;

  std::uint32_t part = nothing;  ///< index into World::parts: the boundary that the ray left last
  bool inside = false;           ///< on its inner side
  int colour = -1;               ///< of red, green and blue, the only one that it brings; -1: all
  int refractions = 0;           ///< on its way, among ViewedRay's bounces
  bool straight = false;         ///< it has come in unbent, and leaves so
  glm::vec3 attenuation_color{1.0f};  ///< Volume's, inside
  float attenuation_distance = std::numeric_limits<float>::infinity();

  /// The share of light that is left of it over a finite way inside (Beer and Lambert).
  [[nodiscard]] glm::vec3 left_after(float length) const {
    return glm::pow(attenuation_color, glm::vec3(length / attenuation_distance));
  }
  [[nodiscard]] bool left_boundary() const { return part != nothing; }

  /// The same ray's on a boundary of a part.
  [[nodiscard]] VolumePath at(std::uint32_t boundary, const Volume& volume, bool inner_side) const {
    VolumePath next;
    next.part = boundary;
    next.inside = inner_side;
    next.colour = colour;
    next.refractions = refractions;
    next.straight = inner_side && straight;
    if (!inner_side) return next;
    next.attenuation_color = volume.attenuation_color;
    next.attenuation_distance = volume.attenuation_distance;
    return next;
  }
};

}  // namespace asos
