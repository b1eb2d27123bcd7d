#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/pyray/subdivide.h"

namespace asos {

/// The facts of a pixel's rendering that decide the cause of its split.
struct PixelFindings {
  SubdivisionOutcome outcome;
  bool by_samples = false;  ///< the safety net split it
  bool shadow_cut = false;  ///< the edge of a hard shadow cut one of its leaves
  bool mirror_cut = false;  ///< a boundary split the reflection of a leaf
  bool defocused = false;   ///< it was sampled over the camera's lens
};

/// Returns the single cause of a pixel's split. Causes that keep it from being resolved
/// come first: saturation, then the depth limit. The others follow in this order: outline,
/// intersection, crease, reflection, shadow, shading. A pixel of level 0 was not split and has no
/// cause, unless the edge of a shadow or a reflection cut its one leaf. A pixel that was sampled
/// over the lens has only that cause.
[[nodiscard]] SplitCause cause_of(const PixelFindings& pixel);

}  // namespace asos
