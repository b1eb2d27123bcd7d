#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// The sphere around an object, which is one part of the world, and how thick the object is.
struct ObjectSphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
  /// How far the object strays from its longest line; between half of its width across that line
  /// and all of it.
  double thickness = 0.0;
  std::uint32_t part = 0;
};

/// The spheres of all parts that have a vertex.
[[nodiscard]] std::vector<ObjectSphere> object_spheres(const World& world);

}  // namespace asos
