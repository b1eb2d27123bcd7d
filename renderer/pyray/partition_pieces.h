#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

// The boundaries of a cell in cell units, with the tolerances for equal points and for points on
// its border.

namespace asos {

/// A straight boundary within the cell.
struct PartitionPiece {
  glm::dvec2 p, q;
};

/// An edge between two nodes, by their indices.
struct PartitionEdge {
  std::uint32_t from, to;
};

/// Points closer than this, in cells, are equal. Segments come in single precision of the root
/// frame, so smaller distances have no meaning. The area of a smaller piece goes to the parts
/// around it: at most snap^2 of the cell each.
inline constexpr double snap = 4e-6;

[[nodiscard]] inline bool are_one(glm::dvec2 p, glm::dvec2 q) {
  const glm::dvec2 d = glm::abs(p - q);
  return d.x < snap && d.y < snap;
}

[[nodiscard]] inline bool on_border(glm::dvec2 p) {
  return p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0;
}

/// Moves a point to the border if it is closer than `snap`.
[[nodiscard]] inline glm::dvec2 snapped(glm::dvec2 p) {
  for (int k = 0; k < 2; ++k) {
    if (p[k] < snap) p[k] = 0.0;
    if (p[k] > 1.0 - snap) p[k] = 1.0;
  }
  return p;
}

/// Connects pieces that end slightly (a 64th of a cell) before another, by additional pieces, so
/// that no line moves. `nodes` and `edges` are those of the given pieces. Returns whether there
/// were any gaps.
[[nodiscard]] bool close_gaps(std::vector<PartitionPiece>& pieces,
                              std::span<const glm::dvec2> nodes,
                              std::span<const PartitionEdge> edges);

}  // namespace asos
