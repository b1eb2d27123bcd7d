#pragma once

#include "renderer/pyray/cell_resolver.h"
#include "renderer/pyray/level_statistics.h"
#include "renderer/pyray/subdivision_state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The subdivision routine for every kind of pyray. It splits squares level by level where
/// boundaries pass through them, until no cell is marginal, the stopping rule holds
/// (SubdivisionRules::ends), or MAX is reached. Roots of one frame are processed together, so that
/// their rays go in packets; none influences another. Reuses its memory; one object per thread.
class Subdivider {
 public:
  /// Returns one outcome per root. The weights of each root's leaves add up to 1, unless the caster
  /// was cancelled.
  std::span<const SubdivisionOutcome> run(BoundarySearch& search, std::span<const Root> roots,
                                          const SubdivisionRules& rules, Caster& caster);

 private:
  void start(std::span<const Root> roots);
  void stop_roots(CellLevel& level);
  void tally(const CellLevel& level, std::span<const Cell> cells);
  void finish_marginal(CellLevel& level);
  void split(const CellLevel& level, CellLevel& next);

  SubdivisionState state_;
  CellLevel levels_[2];
  CellResolver resolver_;
  LevelStatistics tally_;
  // Scratch.
  std::vector<glm::vec2> points_;
  BoundarySearch::List list_;
  BoundarySearch::List visible_;
  std::vector<std::uint32_t> near_;  // objects near the current cell
};

}  // namespace asos
