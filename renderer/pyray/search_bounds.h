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

/// A set of sub-trees of the feature hierarchy that have not been ruled out yet.
using FeatureCut = std::vector<CutNode>;

/// The boundaries that a root pyray searches, besides the limits of its square. For example, a
/// shadow pyray ends at its light, and a lamp's own outline does not bound its light.
struct SearchBounds {
  /// Null: the whole hierarchy.
  const FeatureCut* cut = nullptr;
  /// Boundaries are cut off outside of these half-spaces.
  std::span<const HalfSpace> within;
  /// Boundaries that reach into the first half-space extend this far beyond its plane. So an object
  /// on a patch counts down to the patch itself, although rays end above the patch.
  double beyond_first = 0.0;
  /// Edges that start at one of these vertices do not count.
  std::uint32_t first_ignored_vertex = 0;
  std::uint32_t ignored_vertices = 0;
  /// Edges that start at one of these vertices do not count either: those of lines and points,
  /// which cast no shadows.
  std::uint32_t first_shadowless_vertex = 0;
  std::uint32_t shadowless_vertices = 0;
  /// No more nodes are opened after this many entries.
  std::size_t most_entries = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] bool ignores(std::uint32_t vertex) const {
    return vertex - first_ignored_vertex < ignored_vertices ||
           vertex - first_shadowless_vertex < shadowless_vertices;
  }
};

}  // namespace asos
