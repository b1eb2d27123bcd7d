#pragma once

#include "renderer/lights/lights_without_geometry.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The lights of a scene with all data for shading, computed once. Immutable once shared.
struct Lighting {
  std::vector<Light> lights;        ///< positions relative to World::origin
  std::size_t emissive_lights = 0;  ///< number of those for emissive meshes
  /// The scene has almost no light of its own: the last of `lights` are default lighting.
  bool default_lights_added = false;
  RenderFeatures render_features;  ///< the features of the lights alone
  LightsWithoutGeometry lights_without_geometry;
  /// One entry per World::parts; 1: the surface shows a light and emits as evenly as that light.
  std::vector<std::uint8_t> shows_even_light;
  std::array<std::vector<PreparedLight>, 2> by_rule;  ///< see prepared()

  /// Returns the prepared lights in the order of `lights`, with their intersections
  /// (find_light_intersections).
  [[nodiscard]] std::span<const PreparedLight> prepared(LightRule rule) const {
    return by_rule[static_cast<std::size_t>(rule)];
  }
};

/// Returns the features that lights need in addition to those of their world.
[[nodiscard]] RenderFeatures find_render_features(std::span<const Light> lights);

/// Prepares lights for a world. Takes time for each light, and for finding the light intersections.
[[nodiscard]] Lighting prepare_lighting(const World& world, std::vector<Light> lights);

}  // namespace asos
