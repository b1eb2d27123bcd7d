#pragma once

#include "renderer/asos/error_bound.h"
#include "renderer/pyray/allowance.h"
#include "renderer/pyray/caster.h"

namespace asos {

/// A leaf whose estimator is to be chosen.
struct LeafChoice {
  double weight = 1.0;  ///< fraction of the root's area
  ErrorBound bound;     ///< of its centre: the sum of all error terms
  double price = 1.0;   ///< of one leaf of its surface, in samples
  bool may_split = false;
};

/// Whether MAX, or EPS, leaves so little to find out of a part of this weight that sampling it
/// costs no more than to shade one leaf exactly, whatever it shows.
[[nodiscard]] bool samples_cost_least(const Allowance& allowance, double weight);

/// The cheapest estimator whose error is within the allowance: the leaf's centre, samples of it, or
/// those of its four quarters. If none is, the one with the least error (design section 14).
[[nodiscard]] Estimator choose(const Allowance& allowance, const LeafChoice& leaf);

}  // namespace asos
