#pragma once

#include "renderer/pyray/boundary_search.h"
#include "renderer/pyray/chains.h"
#include "renderer/pyray/partition.h"
#include "renderer/pyray/rules.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The properties of a cell that matter for cutting it.
struct CellToCut {
  Square square;
  int level = 0;
  float root_side = 1.0f;  ///< side of its root's square
  CellOccluder hiding;     ///< from the cover that was used to find its visible boundaries
};

/// A cell cut along its boundaries. The spans are valid until the next cut.
struct CellCut {
  std::span<const CellPart> parts;        ///< empty: the cell could not be cut
  std::span<const BorderEdge> borders;    ///< of the parts
  std::span<const std::uint32_t> along;   ///< the boundaries, as entries of the hit lists
  std::span<const std::uint32_t> hidden;  ///< boundaries that turned out to be hidden
  std::size_t boundaries = 0;             ///< number of edges, or of chains if edges were joined
};

/// Computes exact leaves (CGF'98 sections 6.2 and 6.4; design section 5): the parts of a cell
/// between its few boundaries. One object per thread; reuses its memory.
class CellCutter {
 public:
  /// `visible`: the visible entries of the cell's list.
  [[nodiscard]] CellCut cut(const CellToCut& cell, std::span<const std::uint32_t> visible,
                            const SubdivisionRules& rules, HitLists& lists);

 private:
  [[nodiscard]] bool resolve(const CellToCut& cell, std::span<const std::uint32_t> visible,
                             const SubdivisionRules& rules, HitLists& lists);

  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> resolved_;
  std::vector<std::uint32_t> hidden_;
  std::vector<Segment> segments_;
  ChainSimplifier chains_;
  CellPartition partition_;
};

}  // namespace asos
