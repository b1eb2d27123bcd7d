#include "renderer/asos/predicted_level.h"

#include "renderer/pyray/error_budget.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <cmath>

namespace asos {

LevelPrediction::LevelPrediction(const RenderSettings& rendered, const RenderSettings& asked)
    : max_level_(asked.asos.max_level), eps_(asked.asos.eps) {
  const ErrorBudget before = ErrorBudget::of(rendered), after = ErrorBudget::of(asked);
  tolerance_before_ = static_cast<double>(before.tolerance);
  tolerance_ = static_cast<double>(after.tolerance);
  most_samples_ = after.most_samples(1.0);
  tangle_samples_ = std::max(after.samples(1.0, LeafTuning::contrast_of_many),
                             static_cast<double>(after.pilot_samples(1.0)));
  const double one = before.samples(1.0, ErrorBudget::usual_contrast);
  more_samples_ = after.samples(1.0, ErrorBudget::usual_contrast) / std::max(one, 1.0);
}

int LevelPrediction::level_of(const SplitPredictionData& pixel) const {
  const auto error = static_cast<double>(pixel.error);
  // Cells with boundaries, unless they were split for shading alone.
  const bool for_shading = pixel.unresolved <= 0.0f && !pixel.at_limit &&
                           error > tolerance_before_ && error <= tolerance_;
  if (for_shading) return 0;
  double level = pixel.edges;
  if (pixel.unresolved > 0.0f) {
    const double halvings = std::log2(static_cast<double>(pixel.unresolved) / eps_);
    level = std::max(1.0, level + std::ceil(halvings));
  } else if (pixel.at_limit) {
    level = max_level_;
  }
  return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(max_level_)));
}

std::uint32_t LevelPrediction::samples_of(const SplitPredictionData& pixel,
                                          SplitCause cause) const {
  if (cause == SplitCause::saturation && pixel.edges == 0)
    return static_cast<std::uint32_t>(tangle_samples_);
  double samples = 0.0;
  if (pixel.samples > 0) samples = std::clamp(more_samples_ * pixel.samples, 1.0, most_samples_);
  // A fourfold number of samples halves the error.
  const double times = static_cast<double>(pixel.error) / tolerance_;
  if (times > 1.0) samples = std::max(samples, std::min(std::ceil(times * times), most_samples_));
  return samples > 1.0 ? static_cast<std::uint32_t>(samples) : 0;
}

}  // namespace asos
