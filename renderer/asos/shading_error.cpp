#include "renderer/asos/shading_error.h"

#include <algorithm>
#include <cmath>

namespace asos {

// Each level quarters what is too much of errors and angles squared, and leaves a sixteenth of what
// highlights' means are off by, which take four looks more at each light.
double ShadingError::price_of_splitting(const Budget& budget, double wide, double leaf,
                                        double highlight) const {
  const auto tolerance = static_cast<double>(budget.tolerance);
  if (!(wide > 1.0) && !(error > budget.tolerance))
    return std::sqrt(static_cast<double>(all()) / tolerance) * (leaf + 5.0 * highlight);
  constexpr double splits_much = 12.0;
  const double excess = std::max(static_cast<double>(error) / tolerance, wide * wide);
  return budget.leaves_of_uneven() *
         std::max(leaf * std::min(1.0, excess / splits_much), highlight);
}

// Sixteen samples are off by half of this share of the contrast. What bounds the means' errors is
// met by few of a pixel's finest cells, and the samples' errors by all of them.
bool ShadingError::better_sampled(const Budget& budget) const {
  constexpr float of_few_samples = 0.088f;
  const float usual = static_cast<float>(Budget::usual_contrast);
  const float noise = of_few_samples * (usual + highlights.contrast);
  return error > budget.tolerance || highlights.error > std::max(noise, budget.tolerance);
}

}  // namespace asos
