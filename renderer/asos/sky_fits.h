#pragma once

#include "renderer/asos/sky_leaf.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Shares the sky's contribution between a block's leaves on one surface. Nodes spread over the
/// surface are sampled densely. A fit through the nodes (PolynomialFit) is accepted if its misfit
/// is within the noise of the nodes and does not contradict the few rays of the other leaves. Then
/// all leaves use the fit. Otherwise the surface is divided, and leaves without a fit are sampled
/// themselves. A leaf's error is thus that of its nodes, plus a curvature below the noise.
class SkyFits {
 public:
  /// Leaves that may share a fit.
  struct Cell {
    std::vector<std::uint32_t> lits;
    std::vector<std::uint32_t> nodes;  ///< subset of `lits` with densely sampled rays
    std::uint32_t node_rays = 0;       ///< number of rays per node
  };
  /// Expected noise and cost of a leaf's rays.
  struct Expected {
    double variance = 0.0;   ///< variance of one ray, divided by the leaf's unit
    std::uint32_t rays = 0;  ///< rays that the leaf would need by itself
  };

  /// `standard_error`: allowed error of a whole pixel, in display units. The spans have to outlive
  /// this.
  SkyFits(std::span<SkyLeaf> lits, std::span<const Expected> expected, double standard_error)
      : lits_(lits), expected_(expected), standard_error_(standard_error) {}

  /// Groups the leaves that may share, by surface.
  [[nodiscard]] std::vector<Cell> cells() const;
  /// Chooses nodes. Returns false if sharing does not pay.
  [[nodiscard]] bool choose_nodes(Cell& cell) const;
  /// Assigns the fit to all leaves that do not contradict it, after the nodes were sampled. Returns
  /// false if the nodes do not fit, or too many leaves contradict the fit.
  [[nodiscard]] bool tell(const Cell& cell) const;
  /// Adds a cell's quarters.
  void divide(const Cell& cell, std::vector<Cell>& quarters) const;

 private:
  [[nodiscard]] bool alike(const SkyLeaf& a, const SkyLeaf& b) const;
  [[nodiscard]] std::uint32_t rays_of_nodes(const Cell& cell) const;
  [[nodiscard]] double variance(std::uint32_t lit) const;

  std::span<SkyLeaf> lits_;
  std::span<const Expected> expected_;
  double standard_error_;
};

}  // namespace asos
