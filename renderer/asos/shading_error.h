#pragma once

#include "renderer/pyray/budget.h"
#include "renderer/shading/highlight_unevenness.h"

namespace asos {

/// How far a leaf's shading by one sample may be off its mean, but for boundaries and shadows, in
/// display intensity.
struct ShadingError {
  float error = 0.0f;  ///< but for
  HighlightError highlights;

  [[nodiscard]] float all() const { return error + highlights.error; }

  /// What it costs to split the leaf until all its parts are even, in samples of a part of its
  /// weight. `wide`: how wide it mirrors, in what one reflected pyray may be wide; `leaf` and
  /// `highlight`: the prices of one leaf, and of one look at what its highlights show.
  [[nodiscard]] double price_of_splitting(const Budget& budget, double wide, double leaf,
                                          double highlight) const;

  /// Whether samples would tell more of a leaf than its own mean does, or its middle, where it
  /// cannot be split any more: of highlights, which may be far brighter than white, a few samples
  /// are off by more than the mean is.
  [[nodiscard]] bool better_sampled(const Budget& budget) const;
};

}  // namespace asos
