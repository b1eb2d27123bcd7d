#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// The bounding sphere of an object, which is one part of the world, and the object's thickness.
struct ObjectSphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
  /// Largest distance of the object from its longest line. It is between half of the width across
  /// that line and the whole width.
  double thickness = 0.0;
  std::uint32_t part = 0;
};

/// Returns the spheres of all parts with vertices.
[[nodiscard]] std::vector<ObjectSphere> object_spheres(const World& world);

}  // namespace asos
