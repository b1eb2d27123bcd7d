#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace asos {

/// A straight piece of a line along which two triangles pass through each other.
struct IntersectionLine {
  glm::vec3 a;
  glm::vec3 b;
  std::uint32_t first_triangle = 0;
  std::uint32_t second_triangle = 0;
};

/// How much a scene may cost. Over it there are no lines at all, so that the picture does not
/// depend on threads or on time.
struct IntersectionBudget {
  std::size_t lines = 0;
  std::size_t pairs = 0;  ///< of triangles whose boxes overlap

  /// Sound models have fewer lines than triangles, and 4 to 40 pairs a triangle (most where thin
  /// tubes run aslant, as a bicycle's spokes do). All n triangles of a fan make pairs at its hub,
  /// n^2 / 2 of them: the ends of cylinders, the tips of cones. This is 4 lines and 256 pairs a
  /// triangle, and enough for anything small: 250,000 lines, which are 32 MB (a heap of thirty
  /// balls has seven lines a triangle), and 2^26 pairs (a fan of 11,000 triangles), which take
  /// seconds at most.
  [[nodiscard]] static IntersectionBudget of(const World& world);
};

struct Intersections {
  std::vector<IntersectionLine> lines;  ///< ordered by their triangles
  bool complete = true;  ///< false: more than the budget; `lines` is empty, and the safety net has
                         ///< to find what the samples show of them
};

/// Finds where surfaces of a world pass through each other (design section 3): no mesh edge marks
/// these lines. Triangles that only touch or overlap in one plane have none, and neighbours along
/// an edge of the `welded` mesh (welded_vertices) are passed over. Pairs are found in a tree of
/// boxes (BoxTree). The result does not depend on threads. A scene that is nothing but overlaps is
/// given up after a look at a few of its triangles. So are lines and points, which are looked for
/// where they enter surfaces; without them the rest stays. Throws SearchStopped once `stop` is
/// requested.
[[nodiscard]] Intersections find_intersections(const World& world,
                                               std::span<const std::uint32_t> welded,
                                               const IntersectionBudget& budget,
                                               const std::stop_token& stop = {});

/// The same of placed meshes with each other and with other surfaces, among some triangles alone.
[[nodiscard]] Intersections intersections_among(const World& world,
                                                std::vector<std::uint32_t> triangles,
                                                const IntersectionBudget& budget,
                                                const std::stop_token& stop = {});

}  // namespace asos
