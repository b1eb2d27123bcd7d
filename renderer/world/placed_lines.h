#pragma once

#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <string>

// The lines and points of a scene's meshes. They are added to the World after its surfaces.

namespace asos {

/// Returns the centre of a scene's lines and points; 0 if that is not finite.
[[nodiscard]] glm::dvec3 origin_of_lines(const Scene& scene);

/// Adds the scene's lines and points to the world, with their own parts and materials, unlit where
/// they have no normals. The world must have its origin and all of its materials. Returns an error
/// if a point is not finite, or farther away than single precision allows; else an empty string.
[[nodiscard]] std::string add_strokes(const Scene& scene, World& world);

}  // namespace asos
