#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/pyray/subdivide.h"

namespace asos {

/// The facts about how a pixel was rendered that decide the cause of its split.
struct PixelFindings {
  SubdivisionOutcome outcome;
  bool by_samples = false;  ///< the safety net split it
  bool shadow_cut = false;  ///< the edge of a hard shadow cut one of its leaves
  bool mirror_cut = false;  ///< a boundary split what one of its leaves mirrors
  bool defocused = false;   ///< it was sampled over the camera's lens
};

/// The one cause that a pixel is told to be split for. Causes that keep it from being resolved come
/// first: saturation, then the depth limit. Then what split it first: boundaries come before what
/// is shaded unevenly between them, and of several kinds of boundaries the outline counts before
/// an intersection and that before a crease; then what a mirror shows; of unevenness, a shadow
/// before shading. A pixel whose level is 0 was not split and has no cause, but for an edge of a
/// shadow or in a mirror that cut its one leaf. A pixel that was sampled over the lens has that
/// cause alone.
[[nodiscard]] SplitCause cause_of(const PixelFindings& pixel);

}  // namespace asos
