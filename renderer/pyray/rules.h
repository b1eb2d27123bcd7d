#pragma once

#include "renderer/pyray/allowance.h"
#include "renderer/pyray/subdivision_variant.h"

#include <cstddef>
#include <limits>

namespace asos {

/// How far the engine goes to cut a cell instead of splitting it. The defaults suit pixels, of
/// which there are many and whose children are cheap; a light is looked at once, from afar, and its
/// parts cost a ray each.
struct CutLimits {
  int least_parts = 16;      ///< parts that are allowed at any level
  int most_groups = 8;       ///< groups of boundaries that are resolved at all
  int most_boundaries = 12;  ///< edges, or chains of edges
  int most_pieces = 32;      ///< straight pieces of a few chains
  /// The tolerance on simplified chains, in roots; 0: a 64th of a finest cell, and less in larger
  /// ones.
  float tolerance = 0.0f;
};

/// When to stop and how to sample (CGF'98 section 3.1; design section 5).
struct SubdivisionRules {
  Allowance allowance;
  const SubdivisionVariant* variant = nullptr;  ///< null: the engine's own way
  bool jitter = false;  ///< jitter the samples of cells that stay marginal at MAX
  CutLimits limits;
  /// Boundaries are drawn at least as finely as for a MAX of this, so that they can be cut along.
  int finest_detail = 0;
  /// A single pyray whose list is longer is given up: no part of it is free of boundaries.
  std::size_t most_entries = std::numeric_limits<std::size_t>::max();

  /// As the settings ask for pixels to be subdivided.
  [[nodiscard]] static SubdivisionRules of(const RenderSettings& settings,
                                           const SubdivisionVariant* variant) {
    SubdivisionRules rules;
    rules.allowance = Allowance::of(settings);
    rules.variant = variant;
    rules.jitter = settings.asos.jitter;
    return rules;
  }
  /// Whether a root ends with the marginal cells that a level left.
  [[nodiscard]] bool ends(const LevelTally& tally) const {
    return variant ? variant->ends(tally, allowance.eps) : tally.unresolved_area() <= allowance.eps;
  }
  /// Whether cells are cut along their boundaries.
  [[nodiscard]] bool cuts_cells() const { return !variant || variant->cuts_cells(); }
  /// Boundaries smaller than this are never resolved for their size, in a root of side 1.
  [[nodiscard]] float finest_side() const {
    return std::ldexp(1.0f, -std::max(allowance.max_level, finest_detail));
  }
};

}  // namespace asos
