#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"

namespace asos {

/// What a leaf shows through a surface that blends, where one ray through its middle does not tell.
struct LayeredSight {
  /// Textured layers that blend, one through the other: the mean of what all let through is not the
  /// product of their means, and no outlines bound what alpha blends.
  bool uneven_together = false;
  /// What lies behind is bent or bumpy, or has textures that bring several triangles to it, so that
  /// samples tell more of it (Refinement::better_sampled_at_once says it of what lies in front).
  bool uneven_behind = false;
};
[[nodiscard]] LayeredSight layered_sight(const EyeContext& eye, const EyeSamples& samples,
                                         SampleId sample, double share, const LeafRegion& region);

}  // namespace asos
