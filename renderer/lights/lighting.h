#pragma once

#include "renderer/lights/bare_lights.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// The lights of a scene with all that shading needs of them, worked out once: whoever shades, and
/// by which rule, only reads. Immutable once shared.
struct Lighting {
  std::vector<Light> lights;        ///< positions relative to World::origin
  std::size_t emissive_lights = 0;  ///< of them: those that stand for emissive meshes
  bool default_rig = false;         ///< next to no light came from the scene: they end in a rig
  SceneNeeds needs;                 ///< those of the lights alone
  BareLights bare_lights;
  std::array<std::vector<PreparedLight>, 2> by_rule;  ///< see prepared

  /// In the order of `lights`, with their cuts (find_light_cuts).
  [[nodiscard]] std::span<const PreparedLight> prepared(LightRule rule) const {
    return by_rule[static_cast<std::size_t>(rule)];
  }
};

/// Prepares lights to shine on a world. Takes time for each light, and to find their cuts.
[[nodiscard]] Lighting prepare_lighting(const World& world, std::vector<Light> lights);

}  // namespace asos
