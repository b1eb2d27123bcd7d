#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/world/world.h"

#include <span>
#include <vector>

namespace asos {

/// The lights that stand for the emissive meshes of a world, shaded as the shader shades them.
[[nodiscard]] std::vector<Light> lights_of_meshes(const World& world);

/// Whether no light of the file shines at all and emissive meshes give next to nothing.
[[nodiscard]] bool needs_rig(const World& world, std::span<const Light> lights_of_file,
                             std::span<const Light> emissive);

/// The lights of a scene without its own.
struct DefaultRig {
  std::vector<Light> lights;
  bool inside = false;  ///< an interior's
};

/// A studio around what the first camera sees; or lights inside, where its walls shut a studio out.
/// They have no part of the world as their own, so that the rays need not know of them.
[[nodiscard]] DefaultRig rig_for(const World& world, const RayScene& rays);

/// The first camera of the file, or else the one that frames the scene.
[[nodiscard]] Camera first_camera(const World& world);

}  // namespace asos
