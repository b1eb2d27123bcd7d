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

/// The budget of a scene's search. Beyond it no line is returned, so that the picture does not
/// depend on threads or on time.
struct IntersectionBudget {
  std::size_t lines = 0;
  std::size_t pairs = 0;  ///< triangles with overlapping boxes

  /// Returns the budget of a world. Sound models have fewer lines than triangles, and 4 to 40 pairs
  /// per triangle (most where thin tubes are oblique, like a bicycle's spokes). All n triangles of
  /// a fan make pairs at its hub, n^2 / 2 of them, as at the ends of cylinders and the tips of
  /// cones. The budget is 4 lines and 256 pairs per triangle. Its minimum suits small scenes:
  /// 250,000 lines, which are 32 MB (a heap of thirty balls has seven lines per triangle), and 2^26
  /// pairs (a fan of 11,000 triangles), which take a few seconds.
  [[nodiscard]] static IntersectionBudget of(const World& world);
};

struct Intersections {
  std::vector<IntersectionLine> lines;  ///< ordered by their triangles
  bool complete = true;  ///< false: more than the budget; `lines` is empty, and only the safety
                         ///< net can find the intersections
};

/// Finds where surfaces of a world pass through each other (design section 3); no mesh edge marks
/// these lines. Triangles that only touch, or overlap in one plane, have none, and neighbours along
/// an edge of the `welded` mesh (welded_vertices) are skipped. A tree of boxes (BoxTree) finds the
/// pairs. The result does not depend on threads. A scene with far too many overlaps is given up
/// after a survey of a few triangles. Lines and points are also searched where they enter surfaces,
/// and can be given up separately. Throws SearchStopped once `stop` is requested.
[[nodiscard]] Intersections find_intersections(const World& world,
                                               std::span<const std::uint32_t> welded,
                                               const IntersectionBudget& budget,
                                               const std::stop_token& stop = {});

/// Finds the intersections of placed meshes with each other and with other surfaces, among these
/// triangles only.
[[nodiscard]] Intersections intersections_among(const World& world,
                                                std::vector<std::uint32_t> triangles,
                                                const IntersectionBudget& budget,
                                                const std::stop_token& stop = {});

}  // namespace asos
