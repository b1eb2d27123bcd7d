#pragma once

#include "renderer/pyray/caster.h"
#include "renderer/pyray/square.h"
#include "renderer/pyray/stopping.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// What became of a cell.
enum class CellFate {
  uniform,    ///< no visible boundary: one sample tells all
  cut,        ///< cut along its boundaries, one sample in each part
  uneven,     ///< no boundary, or cut along them, but shaded too unevenly: its four children follow
  split,      ///< marginal: its four children follow
  stopped,    ///< marginal, and the rule held: one sample
  finest,     ///< marginal at MAX: one sample
  saturated,  ///< as many boundaries as finest cells: a jittered sample in each of those
  by_samples  ///< split by the safety net, for what its samples showed
};

struct TracedLeaf {
  Caster::SampleId sample = Caster::no_sample;
  glm::vec2 at{0.0f};   ///< in the root frame
  double weight = 0.0;  ///< share of the root
};

struct TracedCell {
  int level = 0;
  Square square;  ///< of the root frame
  CellFate fate = CellFate::split;
  std::vector<Segment> boundaries;  ///< that may be visible; not clipped to the cell
  std::uint32_t clusters = 0;       ///< nodes of boundaries that were not told apart
  std::uint32_t hidden = 0;         ///< entries that lie behind what the cell's sample met
  std::vector<TracedLeaf> leaves;
};

/// The whole subdivision of one root, cell by cell and level by level.
struct SubdivisionTrace {
  std::vector<LevelTally> levels;  ///< those with marginal cells
  std::vector<TracedCell> cells;   ///< a level after the other
};

}  // namespace asos
