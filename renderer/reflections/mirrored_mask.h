#pragma once

#include "renderer/pyray/square.h"
#include "renderer/reflections/blur_kernel.h"
#include "renderer/reflections/horizon.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace asos {

/// How a blurred pyray's kernel changes with depth. On the mirror all of its width is the pyray's
/// own patch, far away most is the lobe's.
struct BlurByDepth {
  glm::dvec2 far_share{1.0};   ///< share of the width that is not the lobe's, far away
  double apex_distance = 0.0;  ///< from the apex to the mirror
  double start = 0.0;          ///< from the apex to where distances are measured from

  /// At a surface that is met at `t`; infinite: far away.
  [[nodiscard]] BlurKernel at(double t) const {
    if (!std::isfinite(t)) return BlurKernel(far_share);
    const double from_apex = std::max(start + t, apex_distance);
    const double beyond = from_apex - apex_distance;
    return BlurKernel((apex_distance + beyond * far_share) / from_apex);
  }
};

/// The weights of the parts of a mirrored pyray's square: by the blur's kernel; 0 outside of the
/// leaf that was mirrored, and below the mirror. By default each part counts by its area.
struct MirroredMask {
  std::optional<BlurByDepth> blur;
  std::optional<Horizon> horizon;
  std::vector<BorderEdge> outline;  ///< of the leaf; empty: all of the square

  /// Whether a point counts at all. No leaf lies on both sides of what is left out.
  [[nodiscard]] bool holds(glm::vec2 p) const {
    if (horizon && !(horizon->at(glm::dvec2(p)) > 0.0)) return false;
    return outline.empty() || winds_around(outline, p);
  }
};

}  // namespace asos
