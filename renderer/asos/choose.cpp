#include "renderer/asos/choose.h"

#include "renderer/pyray/prices.h"

namespace asos {

bool samples_cost_least(const Allowance& allowance, double weight) {
  return allowance.samples_suffice(weight, Allowance::usual_contrast, Prices::exact_leaf);
}

Estimator choose(const Allowance& allowance, const LeafChoice& leaf) {
  const ErrorBound& bound = leaf.bound;
  if (bound.unbounded) return Estimator::samples;
  if (bound.error <= static_cast<double>(allowance.tolerance)) return Estimator::centre;
  const double contrast = Allowance::usual_contrast + bound.contrast;
  const double samples = allowance.samples(leaf.weight, contrast);
  if (leaf.may_split) {
    const double leaves = allowance.leaves(bound.error);
    return samples <= leaves * leaf.price ? Estimator::samples : Estimator::split;
  }
  return Allowance::error_of_samples(samples, contrast) < bound.error ? Estimator::samples
                                                                      : Estimator::centre;
}

}  // namespace asos
