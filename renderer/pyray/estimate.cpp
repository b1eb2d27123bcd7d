#include "renderer/pyray/estimate.h"

namespace asos {

Estimator choose(const ErrorBudget& error_budget, double weight, const ErrorBound& centre,
                 const EstimatorCosts& costs) {
  if (centre.unbounded) return Estimator::samples;
  const bool within = centre.error <= static_cast<double>(error_budget.tolerance);
  const bool cheap = costs.centre > 0.0 && error_budget.refines();
  if (within && !cheap) return Estimator::centre;
  const double contrast = costs.contrast + centre.contrast;
  const double samples = error_budget.samples(weight, contrast);
  if (cheap && samples <= costs.centre) return Estimator::samples;
  if (within) return Estimator::centre;
  if (costs.quarter) {
    const double quarters = error_budget.leaves(centre.error) * *costs.quarter;
    return samples <= quarters ? Estimator::samples : Estimator::split;
  }
  return ErrorBudget::error_of_samples(samples, contrast) < centre.error ? Estimator::samples
                                                                         : Estimator::centre;
}

}  // namespace asos
