#pragma once

#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <string>

// The lines and points of a scene's meshes, which go into its World once their surfaces are there.

namespace asos {

/// The middle of a scene's lines and points; 0 where that is none.
[[nodiscard]] glm::dvec3 origin_of_strokes(const Scene& scene);

/// Places the scene's lines and points in the world, which has its origin and all of its materials
/// by now, with parts and unlit materials of their own. Returns what is wrong with one, or nothing:
/// it is not finite, or farther away than single precision reaches.
[[nodiscard]] std::string add_strokes(const Scene& scene, World& world);

}  // namespace asos
