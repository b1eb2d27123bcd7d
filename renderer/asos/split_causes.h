#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/pyray/subdivide.h"

namespace asos {

/// The facts of a pixel's rendering that decide the cause of its split.
struct PixelFindings {
  SubdivisionOutcome outcome;
  bool by_samples = false;  ///< the safety net split the pixel
  bool shadow_cut = false;  ///< the edge of a hard shadow cut one of its leaves
  bool mirror_cut = false;  ///< a boundary split the reflection of a leaf
  bool defocused = false;   ///< the pixel was sampled over the camera's lens
};

/// Returns the single cause of a pixel's split, the first that applies: lens (the pixel was sampled
/// over it), cut-out (samples split the pixel), saturation, depth limit, outline, intersection,
/// crease, reflection, shadow, shading. A pixel of level 0 was not split and has no cause, unless
/// it was sampled over the lens or the edge of a shadow or a reflection cut its one leaf.
[[nodiscard]] SplitCause cause_of(const PixelFindings& pixel);

}  // namespace asos
