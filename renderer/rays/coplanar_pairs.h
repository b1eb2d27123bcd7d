#pragma once

#include "renderer/geometry/box.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// The search for coplanar triangles of different parts. Internal to this folder.

namespace asos::tracing {

using Corners = std::array<glm::dvec3, 3>;

[[nodiscard]] Corners corners_of(const World& world, std::uint32_t triangle);
[[nodiscard]] glm::dvec3 normal_of(const Corners& triangle);
/// Returns the largest side of a triangle's box.
[[nodiscard]] float size_of(const World& world, std::uint32_t triangle);
/// Returns the largest rounding error of two triangles' corners, by axis.
[[nodiscard]] glm::dvec3 rounding_of(const Corners& s, const Corners& t, glm::dvec3 origin,
                                     double size);

/// Returns whether the smaller of two triangles lies in the plane of the larger one, and overlaps
/// it. If they have the same size, either plane counts.
[[nodiscard]] bool coplanar(const World& world, std::uint32_t s, std::uint32_t t);

/// A triangle and its box, enlarged by the largest rounding error: boxes of coplanar triangles
/// meet.
struct BoxedTriangle {
  Box box;
  float diameter = 0.0f;  ///< an upper bound on its longest side
  std::uint32_t triangle = 0;
  std::uint32_t part = 0;
  bool open = true;  ///< false: it is not compared with others of this kind
};
[[nodiscard]] BoxedTriangle boxed(const World& world, std::uint32_t triangle);
/// Returns a box that is enlarged in the same way: it contains the enlarged boxes of its triangles.
[[nodiscard]] Box enlarged(const Box& box, glm::dvec3 origin);

[[nodiscard]] inline bool meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

/// A marked triangle, and one of another part that it is coplanar with.
struct Partner {
  std::uint32_t triangle = 0;
  std::uint32_t other = 0;
};

/// Marks the triangles that are coplanar with one of another part. `marks` has an entry for each
/// of the world's own triangles. Adds the newly marked ones to `partners`. Returns the number of
/// pairs that it compared.
///
/// Finds the pairs by a hierarchy of boxes, which is traversed against itself. Nodes are split when
/// they are first visited, and nodes of one part are not compared with themselves. Triangles are
/// tested exactly against the boxes of others, since the box of a long triangle meets many others.
std::size_t mark_coplanar(const World& world, std::vector<BoxedTriangle> triangles,
                          std::vector<std::uint8_t>& marks, std::vector<Partner>& partners);

}  // namespace asos::tracing
