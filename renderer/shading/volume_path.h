#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asos {

/// The volumes that a place lies in, by their parts (World::parts), the one that is the medium
/// there first: KHR_materials_volume says nothing of volumes in each other, so the smallest box is.
/// No more than `most`; the largest are forgotten.
struct NestedVolumes {
  static constexpr std::uint32_t nothing = 0xffffffffu;
  static constexpr std::size_t most = 4;

  std::array<std::uint32_t, most> parts{nothing, nothing, nothing, nothing};

  [[nodiscard]] std::uint32_t medium() const { return parts[0]; }
  bool operator==(const NestedVolumes&) const = default;
};

/// Where a ray is among the volumes that surfaces bound (KHR_materials_volume).
struct VolumePath {
  static constexpr std::uint32_t nothing = NestedVolumes::nothing;

  std::uint32_t part = nothing;  ///< index into World::parts: the boundary that the ray left last
  bool inside = false;           ///< on its inner side
  int colour = -1;               ///< of red, green and blue, the only one that it brings; -1: all
  int refractions = 0;           ///< on its way, among ViewedRay's bounces
  bool straight = false;         ///< it has come in unbent, and leaves so
  NestedVolumes around;          ///< what it is in
  glm::vec3 attenuation_color{1.0f};  ///< the medium's
  float attenuation_distance = std::numeric_limits<float>::infinity();

  /// The share of light that is left of it over a finite way in the medium (Beer and Lambert).
  [[nodiscard]] glm::vec3 left_after(float length) const {
    return glm::pow(attenuation_color, glm::vec3(length / attenuation_distance));
  }
  [[nodiscard]] bool left_boundary() const { return part != nothing; }
  [[nodiscard]] bool in_medium() const { return around.medium() != nothing; }
};

}  // namespace asos
