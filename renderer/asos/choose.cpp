#include "renderer/asos/choose.h"

#include "renderer/pyray/leaf_costs.h"

namespace asos {

bool samples_cost_least(const ErrorBudget& error_budget, double weight) {
  return error_budget.samples_suffice(weight, ErrorBudget::usual_contrast, LeafCosts::exact_leaf);
}

Estimator choose(const ErrorBudget& error_budget, const LeafChoice& leaf) {
  const ErrorBound& bound = leaf.bound;
  if (bound.unbounded) return Estimator::samples;
  if (bound.error <= static_cast<double>(error_budget.tolerance)) return Estimator::centre;
  const double contrast = ErrorBudget::usual_contrast + bound.contrast;
  const double samples = error_budget.samples(leaf.weight, contrast);
  if (leaf.may_split) {
    const double leaves = error_budget.leaves(bound.error);
    return samples <= leaves * leaf.price ? Estimator::samples : Estimator::split;
  }
  return ErrorBudget::error_of_samples(samples, contrast) < bound.error ? Estimator::samples
                                                                        : Estimator::centre;
}

}  // namespace asos
