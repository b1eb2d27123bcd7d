#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace asos {

/// The line where a plane cuts a triangle, in the world.
struct SectionLine {
  glm::dvec3 from{0.0}, to{0.0};
};
using PlaneSection = std::vector<SectionLine>;

/// Returns the lines where a plane cuts the triangles of a world's surfaces. The visible surfaces
/// end there if it is a camera's plane, since rays start or end in that plane. Leaves out triangles
/// entirely in front of it, even if they touch it, and analytic shapes.
[[nodiscard]] PlaneSection plane_section(const World& world, const HalfSpace& plane);

/// Caches the last two sections, for all blocks of a picture. Thread-safe.
class PlaneSections {
 public:
  [[nodiscard]] std::shared_ptr<const PlaneSection> of(const World& world,
                                                       const HalfSpace& plane) const;

 private:
  struct Kept {
    HalfSpace plane;
    std::shared_ptr<const PlaneSection> section;
  };
  mutable std::mutex mutex_;
  mutable std::array<Kept, 2> kept_;  // the newer one first
};

}  // namespace asos
