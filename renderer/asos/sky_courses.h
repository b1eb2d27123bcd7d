#pragma once

#include "renderer/asos/sky_lit.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// How a block's leaves of one surface learn from some of them what all get of the sky: nodes,
/// spread over the surface, take rays enough to be known well. Where a course through them (Course)
/// lies within what their noise explains, and the few rays of the others do not contradict it, all
/// take what it tells; where not, the surface is divided, and what is left of it in the end takes
/// rays of its own. So a leaf is off by what its nodes are, and a bend that noise hides.
class SkyCourses {
 public:
  /// Leaves that may share a course.
  struct Cell {
    std::vector<std::uint32_t> lits;
    std::vector<std::uint32_t> nodes;  ///< of these
    std::uint32_t node_rays = 0;       ///< of each
  };
  /// What is expected of a leaf's rays.
  struct Expected {
    double variance = 0.0;   ///< of one, over the leaf's unit
    std::uint32_t rays = 0;  ///< it would take by itself
  };

  /// `standard_error`: what a whole pixel may be off by, in display units. The spans stay as long.
  SkyCourses(std::span<SkyLit> lits, std::span<const Expected> expected, double standard_error)
      : lits_(lits), expected_(expected), standard_error_(standard_error) {}

  /// By surfaces, of those leaves that may share at all.
  [[nodiscard]] std::vector<Cell> cells() const;
  /// Chooses nodes. False: it does not pay.
  [[nodiscard]] bool choose_nodes(Cell& cell) const;
  /// Tells all leaves that nothing contradicts it for, once the nodes have their rays. False: the
  /// nodes lie on no course, or too many contradict.
  [[nodiscard]] bool tell(const Cell& cell) const;
  /// Adds a cell's quarters.
  void divide(const Cell& cell, std::vector<Cell>& quarters) const;

 private:
  [[nodiscard]] bool alike(const SkyLit& a, const SkyLit& b) const;
  [[nodiscard]] std::uint32_t rays_of_nodes(const Cell& cell) const;
  [[nodiscard]] double variance(std::uint32_t lit) const;

  std::span<SkyLit> lits_;
  std::span<const Expected> expected_;
  double standard_error_;
};

}  // namespace asos
