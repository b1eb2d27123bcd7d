#include "renderer/asos/split_causes.h"

namespace asos {

SplitCause cause_of(const PixelFindings& pixel) {
  if (pixel.defocused) return SplitCause::lens;
  const SubdivisionOutcome& outcome = pixel.outcome;
  if (outcome.deepest == 0) {
    if (pixel.mirror_cut) return SplitCause::reflection;
    return pixel.shadow_cut ? SplitCause::shadow : SplitCause::none;
  }
  if (pixel.by_samples) return SplitCause::cut_out;
  if (outcome.saturated) return SplitCause::saturation;
  if (outcome.at_limit) return SplitCause::depth_limit;
  const BoundaryKinds kinds = outcome.boundaries;
  if (kinds.has(FeatureKind::open) || kinds.has(FeatureKind::silhouette) ||
      kinds.has(FeatureKind::cut_out))
    return SplitCause::outline;
  if (kinds.has(FeatureKind::intersection)) return SplitCause::intersection;
  if (kinds.has(FeatureKind::crease) || kinds.has(FeatureKind::seam)) return SplitCause::crease;
  if (pixel.mirror_cut) return SplitCause::reflection;
  if (outcome.uneven_shadow) return SplitCause::shadow;
  if (outcome.uneven_shading) return SplitCause::shading;
  // Only hidden boundaries are left: an unresolved group of edges counted as visible.
  return SplitCause::outline;
}

}  // namespace asos
