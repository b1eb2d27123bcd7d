#pragma once

#include "renderer/lights/lights_without_geometry.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The lights of a scene with all that shading needs of them, worked out once: whoever shades, and
/// by which rule, only reads. Immutable once shared.
struct Lighting {
  std::vector<Light> lights;        ///< positions relative to World::origin
  std::size_t emissive_lights = 0;  ///< how many of them stand for emissive meshes
  bool default_rig = false;         ///< next to no light came from the scene: they end in a rig
  SceneNeeds needs;                 ///< those of the lights alone
  LightsWithoutGeometry lights_without_geometry;
  /// By index in World::parts: 1 for surfaces that shine as evenly as the lights that they show.
  std::vector<std::uint8_t> shows_even_light;
  std::array<std::vector<PreparedLight>, 2> by_rule;  ///< see prepared

  /// In the order of `lights`, with their intersections (find_light_intersections).
  [[nodiscard]] std::span<const PreparedLight> prepared(LightRule rule) const {
    return by_rule[static_cast<std::size_t>(rule)];
  }
};

/// Prepares lights to shine on a world. Takes time for each light, and to find the light
/// intersections.
[[nodiscard]] Lighting prepare_lighting(const World& world, std::vector<Light> lights);

}  // namespace asos
