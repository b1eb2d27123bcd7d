#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Animated built-in scenes.

namespace asos::builtin {

/// The placement of one instance as a function of animation time, in seconds.
struct Motion {
  std::size_t instance = 0;  ///< index into Scene::instances
  std::function<glm::dmat4(double seconds)> world_from_mesh;
};

/// Returns the scene with an animation of this name, `seconds` long, and a rig that poses it. The
/// rest pose is that at time 0; after the end nothing moves.
[[nodiscard]] Scene with_animation(Scene scene, std::string name, double seconds,
                                   std::vector<Motion> motions);

}  // namespace asos::builtin
