#include "renderer/prepared/plane_section.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace asos {
namespace {

bool straddles(const Box& box, const HalfSpace& plane) {
  if (box.empty()) return true;
  const glm::dvec3 middle = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  const glm::dvec3 half = 0.5 * (glm::dvec3(box.hi) - glm::dvec3(box.lo));
  return std::abs(plane.height(middle)) <= glm::dot(glm::abs(plane.normal), half);
}

void add_line(const std::array<glm::dvec3, 3>& corner, const HalfSpace& plane,
              PlaneSection& section) {
  std::array<double, 3> height{};
  for (std::size_t i = 0; i < 3; ++i) height[i] = plane.height(corner[i]);
  // A corner in the plane counts as above it.
  std::array<glm::dvec3, 2> ends{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((height[i] < 0.0) == (height[j] < 0.0)) continue;
    ends[count++] = glm::mix(corner[i], corner[j], height[i] / (height[i] - height[j]));
  }
  if (count == 2) section.push_back({ends[0], ends[1]});
}

}  // namespace

PlaneSection plane_section(const World& world, const HalfSpace& plane) {
  PlaneSection section;
  for (std::size_t p = 0; p < world.solid_parts(); ++p) {
    const Part& part = world.parts[p];
    if (!straddles(part.bounds, plane)) continue;
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
      const glm::uvec3 t = world.triangles[part.first_triangle + i];
      add_line({glm::dvec3(world.positions[t.x]), glm::dvec3(world.positions[t.y]),
                glm::dvec3(world.positions[t.z])},
               plane, section);
    }
  }
  return section;
}

std::shared_ptr<const PlaneSection> PlaneSections::of(const World& world,
                                                      const HalfSpace& plane) const {
  const std::lock_guard lock(mutex_);
  for (const Kept& kept : kept_)
    if (kept.section && kept.plane.normal == plane.normal && kept.plane.offset == plane.offset)
      return kept.section;
  kept_[1] = std::move(kept_[0]);
  kept_[0] = {plane, std::make_shared<const PlaneSection>(plane_section(world, plane))};
  return kept_[0].section;
}

}  // namespace asos
