#pragma once

#include "renderer/geometry/half_space.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace asos {

/// Some children of a node of the feature hierarchy.
struct CutNode {
  std::uint32_t node = 0;
  std::uint32_t children = 0;  ///< bit i: child i
};

/// A set of sub-trees of the feature hierarchy: all that somebody has not ruled out yet.
using FeatureCut = std::vector<CutNode>;

/// Which boundaries a root pyray looks at, besides those outside of its square: a shadow pyray ends
/// at its light, and a lamp's own outline does not bound its light.
struct SearchBounds {
  /// Null: the whole hierarchy.
  const FeatureCut* cut = nullptr;
  /// Boundaries are cut off outside of these.
  std::span<const HalfSpace> within;
  /// Those that reach into the first half-space go on so far beyond its plane: what stands on a
  /// patch bounds it down to the patch itself, although rays end above.
  double beyond_first = 0.0;
  /// Edges that start at one of these vertices do not count.
  std::uint32_t first_ignored_vertex = 0;
  std::uint32_t ignored_vertices = 0;
  /// Nor do those that start at one of these: lines and points cast no shadows.
  std::uint32_t first_shadowless_vertex = 0;
  std::uint32_t shadowless_vertices = 0;
  /// Once so many entries were looked at, no more nodes are opened.
  std::size_t most_entries = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] bool ignores(std::uint32_t vertex) const {
    return vertex - first_ignored_vertex < ignored_vertices ||
           vertex - first_shadowless_vertex < shadowless_vertices;
  }
};

}  // namespace asos
