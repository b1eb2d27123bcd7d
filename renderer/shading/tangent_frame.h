#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

namespace asos {

/// glTF's tangent space at a hit: unit, perpendicular to the normal and to each other.
struct TangentFrame {
  glm::vec3 along_u{0.0f};  ///< 0 where the direction is unknown
  glm::vec3 along_v{0.0f};  ///< the bitangent: up in a normal map, opposite to the coordinate v

  [[nodiscard]] bool known() const { return along_u != glm::vec3(0.0f); }
};

/// Returns the frame of the mesh's tangents or, without any, of the direction in which `use`'s u
/// grows. `normal` is unit and on the front side, which the triangle's corners or normals define.
[[nodiscard]] TangentFrame tangent_frame(const World& world, const Hit& hit, const TextureUse& use,
                                         glm::vec3 normal);

}  // namespace asos
