#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Built-in scenes of which something moves.

namespace asos::builtin {

/// Where one instance of a scene is placed at a time of its animation, in seconds.
struct Motion {
  std::size_t instance = 0;  ///< index into Scene::instances
  std::function<glm::dmat4(double seconds)> world_from_mesh;
};

/// The scene with an animation of this name, `seconds` long, and a rig that poses it. At rest it is
/// as at the beginning; after its end it stands still.
[[nodiscard]] Scene with_animation(Scene scene, std::string name, double seconds,
                                   std::vector<Motion> motions);

}  // namespace asos::builtin
