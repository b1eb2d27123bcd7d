#pragma once

#include "renderer/asos/error_bound.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/error_budget.h"

namespace asos {

/// A leaf whose estimator is to be chosen.
struct LeafChoice {
  double weight = 1.0;  ///< fraction of the root's area
  ErrorBound bound;     ///< error bound of its centre: the sum of all error terms
  double price = 1.0;   ///< cost of one leaf of its surface, in samples
  bool may_split = false;
};

/// Returns whether MAX or EPS allows so few samples for a part of this weight that sampling it
/// costs no more than shading one leaf exactly.
[[nodiscard]] bool samples_cost_least(const ErrorBudget& error_budget, double weight);

/// Returns the cheapest estimator with an error within the allowance: the leaf's centre, samples of
/// the leaf, or its four quarters. If none qualifies, returns the one with the least error (design
/// section 14).
[[nodiscard]] Estimator choose(const ErrorBudget& error_budget, const LeafChoice& leaf);

}  // namespace asos
