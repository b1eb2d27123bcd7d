#pragma once

#include "renderer/pyray/boundary_search.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/observer.h"
#include "renderer/pyray/rules.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A pyray to subdivide: a square of the frame, and the boundaries that pass through it.
struct Root {
  Square square;
  std::span<const std::uint32_t> list;  ///< hit list for the reach of the detection
  SampleId middle = no_sample;          ///< at the square's centre, if known
  std::uint32_t id = 0;                 ///< passed on with its leaves
  std::uint64_t seed = 0;               ///< for jittered samples
  TracedPyray* traced = nullptr;        ///< record of its subdivision, if any

  /// Returns a point of the frame in the root's own square.
  [[nodiscard]] glm::vec2 place(glm::vec2 p) const {
    return (p - glm::vec2(square.u, square.v)) / square.side;
  }
  /// Returns the sides of a region in the root's own square; without a border, those of its square.
  [[nodiscard]] std::vector<BorderEdge> placed_border(const LeafRegion& region) const;
};

/// The result of a root's subdivision.
struct SubdivisionOutcome {
  int deepest = 0;               ///< finest level examined; a cut counts as one more
  double unresolved_area = 0.0;  ///< fraction of the root whose cells stayed marginal
  bool uneven_shading = false;   ///< a cell was split or sampled for its shading alone
  bool uneven_shadow = false;    ///< a cell was split or sampled for a shadow on it alone
  bool saturated = false;        ///< a cell went to its finest samples immediately
  bool at_limit = false;         ///< cells stayed marginal at MAX and the rule did not hold
  /// The visible boundaries of cells that were cut or stayed marginal to the end.
  BoundaryKinds boundaries;
  std::array<std::uint32_t, max_level_limit + 1> pyrays_by_level{};
  std::uint32_t probes = 0;  ///< rays of the root's centre, its cells and their parts

  void note_uneven(LeafVariation uneven) {
    uneven_shading |= uneven == LeafVariation::shading;
    uneven_shadow |= uneven == LeafVariation::shadow;
  }
};

/// A square of a level, with its state.
struct Cell {
  Square square;
  std::uint32_t root = 0;
  std::uint32_t first = 0;  ///< where its list begins in the level's entries
  std::uint32_t count = 0;
  OccluderPlane cover{};  ///< of a sample in the cell's closure
  SampleId middle = no_sample;
  bool fresh = false;  ///< its centre was sampled in this level's first round
  bool done = false;
  /// Boundaries hidden from a sample are visible elsewhere in the cell.
  bool nothing_hides = false;
  LeafVariation uneven = LeafVariation::none;  ///< only this keeps the cell from being resolved

  [[nodiscard]] bool is_uneven() const { return uneven != LeafVariation::none; }
};

/// The undecided cells of one level K, root by root, with their hit lists.
struct CellLevel {
  int number = 0;  ///< K
  std::vector<Cell> cells;
  std::vector<std::uint32_t> entries;

  [[nodiscard]] std::span<const std::uint32_t> list(const Cell& cell) const {
    return std::span(entries).subspan(cell.first, cell.count);
  }
};

/// The inputs and results of a subdivision in progress.
struct SubdivisionState {
  BoundarySearch* search = nullptr;
  Caster* caster = nullptr;
  SubdivisionRules rules;
  std::span<const Root> roots;
  std::vector<SubdivisionOutcome> outcomes;  ///< one per root
  std::vector<PyrayLeaf> leaves;             ///< finished, but not passed to the caster yet

  [[nodiscard]] const Root& root(const Cell& cell) const { return roots[cell.root]; }
  [[nodiscard]] SubdivisionOutcome& outcome(const Cell& cell) { return outcomes[cell.root]; }
  [[nodiscard]] BoundarySearch::Sight sight(const Cell& cell) const {
    return search->sight(cell.square, cell.cover);
  }

  /// Returns a cell's fraction of its root's area.
  [[nodiscard]] double weight(const Cell& cell) const;
  /// Returns a random point of a square of a root, which depends on the root's seed and the square
  /// only.
  [[nodiscard]] glm::vec2 jittered(std::uint32_t root, const Square& square) const;

  void add_leaf(const Cell& cell, const PyrayLeaf& leaf);
  /// Passes the leaves to the caster.
  void hand_out();

  /// Records the fate of a cell, with its visible boundaries; null if there is no observer.
  TracedCell* trace(const CellLevel& level, const Cell& cell, CellFate fate,
                    std::span<const std::uint32_t> visible) const;
};

}  // namespace asos
