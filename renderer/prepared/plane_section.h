#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace asos {

/// Where a plane cuts a triangle, in the world.
struct SectionLine {
  glm::dvec3 from{0.0}, to{0.0};
};
using PlaneSection = std::vector<SectionLine>;

/// The lines along which a plane cuts the triangles of a world's surfaces: what a camera's plane
/// leaves of them ends there, for its rays start or end in that plane. None of triangles
/// that are wholly ahead of it, though they touch it, nor of analytic shapes.
[[nodiscard]] PlaneSection plane_section(const World& world, const HalfSpace& plane);

/// Keeps the two sections that were asked for last, for all blocks of a picture. Thread-safe.
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
