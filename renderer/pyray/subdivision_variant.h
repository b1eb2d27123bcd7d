#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/level_statistics.h"
#include "renderer/pyray/square.h"

#include <memory>

namespace asos {

/// A test for boundaries near a cell of a root frame that reaches beyond the cell.
class DetectionTest {
 public:
  virtual ~DetectionTest() = default;

  /// Returns the smallest square, up to rounding, that contains everything that can count as near
  /// `cell`.
  [[nodiscard]] virtual Square reach(const Square& cell) const = 0;
  /// Returns whether a boundary that meets `reach(cell)` counts.
  [[nodiscard]] virtual bool near(const Segment& s, const Square& cell) const = 0;
};

/// Replaces parts of the engine's subdivision (renderer/published). The engine itself detects the
/// boundaries that meet a cell, ends a root whose unresolved area is within EPS, and cuts cells
/// along their boundaries.
class SubdivisionVariant {
 public:
  virtual ~SubdivisionVariant() = default;

  /// Returns the detection in a root frame; null: the engine's detection.
  [[nodiscard]] virtual std::unique_ptr<const DetectionTest> detection(
      const Frame& frame) const = 0;
  /// Returns whether a root ends after a level with these marginal cells.
  [[nodiscard]] virtual bool ends(const LevelStatistics& tally, double eps) const = 0;
  /// Returns whether cells are cut along their boundaries; false: point leaves.
  [[nodiscard]] virtual bool cuts_cells() const = 0;
};

}  // namespace asos
