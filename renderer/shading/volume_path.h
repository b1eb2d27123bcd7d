#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asos {

/// The volumes that contain a point, by their parts (World::parts). The first is the medium there:
/// KHR_materials_volume does not define nested volumes, so the one with the smallest box is used.
/// Holds at most `most`; the largest are dropped.
struct NestedVolumes {
  static constexpr std::uint32_t nothing = 0xffffffffu;
  static constexpr std::size_t most = 4;

  std::array<std::uint32_t, most> parts{nothing, nothing, nothing, nothing};

  [[nodiscard]] std::uint32_t medium() const { return parts[0]; }
  bool operator==(const NestedVolumes&) const = default;
};

/// The position of a ray among the volumes that surfaces bound (KHR_materials_volume).
struct VolumePath {
  static constexpr std::uint32_t nothing = NestedVolumes::nothing;

  std::uint32_t part = nothing;  ///< index into World::parts: the last boundary that the ray left
  bool inside = false;           ///< the ray is on the inner side of that boundary
  /// 0 to 2: the only colour of the ray, red, green or blue; -1: all.
  int colour = -1;
  int refractions = 0;                ///< along the path, among ViewedRay's bounces
  bool straight = false;              ///< the ray passes the medium without deflection
  NestedVolumes around;               ///< the enclosing volumes
  glm::vec3 attenuation_color{1.0f};  ///< of the medium
  float attenuation_distance = std::numeric_limits<float>::infinity();

  /// Returns the fraction of light that remains after a finite distance in the medium (Beer and
  /// Lambert).
  [[nodiscard]] glm::vec3 left_after(float length) const {
    return glm::pow(attenuation_color, glm::vec3(length / attenuation_distance));
  }
  [[nodiscard]] bool left_boundary() const { return part != nothing; }
  [[nodiscard]] bool in_medium() const { return around.medium() != nothing; }
};

}  // namespace asos
