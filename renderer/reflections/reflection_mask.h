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

/// The blur kernel of a pyray as a function of depth. At the mirror, the whole width is the pyray's
/// own patch; far away, most of it is the lobe's.
struct BlurByDepth {
  glm::dvec2 far_share{1.0};   ///< fraction of the width without the lobe, far away
  double apex_distance = 0.0;  ///< from the apex to the mirror
  double start = 0.0;          ///< from the apex to the origin of distances

  /// Returns the kernel at a surface hit at `t`; infinite: far away.
  [[nodiscard]] BlurKernel at(double t) const {
    if (!std::isfinite(t)) return BlurKernel(far_share);
    const double from_apex = std::max(start + t, apex_distance);
    const double beyond = from_apex - apex_distance;
    return BlurKernel((apex_distance + beyond * far_share) / from_apex);
  }
};

/// Weights of the parts of a reflected pyray's square: by the blur kernel, and 0 outside of the
/// reflected leaf or below the mirror. By default the weights are the areas.
struct ReflectionMask {
  std::optional<BlurByDepth> blur;
  std::optional<Horizon> horizon;
  std::vector<BorderEdge> outline;  ///< of the leaf; empty: the whole square

  /// Returns whether a point counts. No leaf crosses the border of the excluded parts.
  [[nodiscard]] bool holds(glm::vec2 p) const {
    if (horizon && !(horizon->at(glm::dvec2(p)) > 0.0)) return false;
    return outline.empty() || winds_around(outline, p);
  }
};

}  // namespace asos
