#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/world/world.h"

#include <span>
#include <vector>

namespace asos {

/// Returns the lights that represent the emissive meshes of a world, with the shader's emission.
[[nodiscard]] std::vector<Light> lights_of_meshes(const World& world);

/// Returns whether the file has no effective lights, and emissive meshes contribute almost nothing.
[[nodiscard]] bool needs_default_lighting(const World& world, std::span<const Light> lights_of_file,
                                          std::span<const Light> emissive);

/// The default lights of a scene.
struct DefaultLighting {
  std::vector<Light> lights;
  bool inside = false;  ///< the lights are inside a room
};

/// Returns a studio around the first camera's view, or lights inside if walls block a studio. They
/// have no own part in the world, so the rays do not depend on them. `bounds`: the world's, without
/// its ground. The ground is ignored.
[[nodiscard]] DefaultLighting default_lighting(const World& world, const Box& bounds,
                                               const RayScene& rays);

/// Returns the first camera of the file, or else the one that frames the scene.
[[nodiscard]] Camera first_camera(const World& world);

}  // namespace asos
