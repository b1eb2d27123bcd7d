#pragma once

#include "renderer/geometry/frame.h"
#include "renderer/pyray/level_tally.h"
#include "renderer/pyray/square.h"

#include <memory>

namespace asos {

/// A test for boundaries near the cells of one root frame that reaches beyond them.
class DetectionTest {
 public:
  virtual ~DetectionTest() = default;

  /// The smallest square, to rounding, that holds everything that can count as near `cell`.
  [[nodiscard]] virtual Square reach(const Square& cell) const = 0;
  /// Whether a boundary that meets `reach(cell)` counts.
  [[nodiscard]] virtual bool near(const Segment& s, const Square& cell) const = 0;
};

/// A way to subdivide that differs from the engine's (renderer/published). The engine detects the
/// boundaries that meet a cell, ends a root whose unresolved area is within EPS, and cuts cells
/// along their boundaries.
class SubdivisionVariant {
 public:
  virtual ~SubdivisionVariant() = default;

  /// The detection in a root frame; null: the engine's.
  [[nodiscard]] virtual std::unique_ptr<const DetectionTest> detection(
      const Frame& frame) const = 0;
  /// Whether a root ends after a level, its marginal cells being as counted.
  [[nodiscard]] virtual bool ends(const LevelTally& tally, double eps) const = 0;
  /// Whether cells are cut along their boundaries; false: point leaves.
  [[nodiscard]] virtual bool cuts_cells() const = 0;
};

}  // namespace asos
