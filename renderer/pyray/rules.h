#pragma once

#include "renderer/pyray/error_budget.h"
#include "renderer/pyray/subdivision_variant.h"

#include <cstddef>
#include <limits>

namespace asos {

/// Limits for cutting a cell instead of splitting it. The defaults suit pixels, which are many and
/// have cheap children. Lights need other limits: each is seen once, from a distance, and its parts
/// cost a ray each.
struct CutLimits {
  int least_parts = 16;      ///< number of parts allowed at any level
  int most_groups = 8;       ///< number of groups of boundaries to resolve
  int most_boundaries = 12;  ///< number of edges, or chains of edges
  int most_pieces = 32;      ///< number of straight pieces of a few chains
  /// The tolerance of simplified chains, in sides of the root; 0: a 64th of a finest cell, and less
  /// in larger cells.
  float tolerance = 0.0f;
};

/// When to stop and how to sample (CGF'98 section 3.1; design section 5).
struct SubdivisionRules {
  ErrorBudget error_budget;
  const SubdivisionVariant* variant = nullptr;  ///< null: the engine's own rules
  bool jitter = false;  ///< jitter the samples of cells that stay marginal at MAX
  CutLimits limits;
  /// Boundaries are at least as detailed as for this MAX, so that cells can be cut along them.
  int finest_detail = 0;
  /// A single pyray with a longer list is given up, since no part of it is free of boundaries.
  std::size_t most_entries = std::numeric_limits<std::size_t>::max();

  /// Returns the rules for pixels in the settings.
  [[nodiscard]] static SubdivisionRules of(const RenderSettings& settings,
                                           const SubdivisionVariant* variant) {
    SubdivisionRules rules;
    rules.error_budget = ErrorBudget::of(settings);
    rules.variant = variant;
    rules.jitter = settings.asos.jitter;
    return rules;
  }
  /// Returns whether a root ends after a level with these marginal cells.
  [[nodiscard]] bool ends(const LevelStatistics& tally) const {
    return variant ? variant->ends(tally, error_budget.eps)
                   : tally.unresolved_area() <= error_budget.eps;
  }
  /// Returns whether cells are cut along their boundaries.
  [[nodiscard]] bool cuts_cells() const { return !variant || variant->cuts_cells(); }
  /// Returns the size below which boundaries are too small to be resolved, in a root of side 1.
  [[nodiscard]] float finest_side() const {
    return std::ldexp(1.0f, -std::max(error_budget.max_level, finest_detail));
  }
};

}  // namespace asos
