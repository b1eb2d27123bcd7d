#pragma once

#include "renderer/pyray/allowance.h"
#include "renderer/settings/choices.h"

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
  StoppingRule rule = StoppingRule::unresolved;
  Detection detection = Detection::square;
  bool exact_leaves = true;  ///< cut cells along their boundaries; false: point leaves
  bool jitter = false;       ///< jitter the samples of cells that stay marginal at MAX
  CutLimits limits;
  /// Boundaries are drawn at least as finely as for a MAX of this, so that they can be cut along.
  int finest_detail = 0;
  /// A single pyray whose list is longer is given up: no part of it is free of boundaries.
  std::size_t most_entries = std::numeric_limits<std::size_t>::max();

  /// As the settings ask for pixels to be subdivided.
  [[nodiscard]] static SubdivisionRules of(const RenderSettings& settings) {
    SubdivisionRules rules;
    rules.allowance = Allowance::of(settings);
    rules.rule = settings.asos.rule;
    rules.detection = settings.asos.detect;
    rules.exact_leaves = settings.asos.leaf == LeafKind::exact;
    rules.jitter = settings.asos.jitter;
    return rules;
  }
  /// Boundaries smaller than this are never resolved for their size, in a root of side 1.
  [[nodiscard]] float finest_side() const {
    return std::ldexp(1.0f, -std::max(allowance.max_level, finest_detail));
  }
};

}  // namespace asos
