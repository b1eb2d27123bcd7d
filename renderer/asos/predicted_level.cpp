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

int LevelPrediction::level_of(const SplitPredictionData& pixel, SplitCause cause) const {
  const auto error = static_cast<double>(pixel.error);
  double level = 0.0;
  // Boundaries, unless the cells that they cut were split for shading alone.
  const bool for_shading = pixel.unresolved <= 0.0f && !pixel.at_limit &&
                           error > tolerance_before_ && error <= tolerance_;
  if (cause == SplitCause::saturation && pixel.edges == 0) {
    level = std::ceil(0.5 * std::log2(tangle_samples_));
  } else if (!for_shading && (pixel.edges > 0 || pixel.unresolved > 0.0f || pixel.at_limit)) {
    level = pixel.edges;
    if (pixel.unresolved > 0.0f) {
      const double halvings = std::log2(static_cast<double>(pixel.unresolved) / eps_);
      level = std::max(1.0, level + std::ceil(halvings));
    } else if (pixel.at_limit) {
      level = max_level_;
    }
  }
  // Shading error.
  if (error > tolerance_) level = std::max(level, std::ceil(0.5 * std::log2(error / tolerance_)));
  // Sample count.
  if (pixel.samples > 1) {
    const double samples = std::clamp(more_samples_ * pixel.samples, 1.0, most_samples_);
    level = std::max(level, std::ceil(0.5 * std::log2(samples)));
  }
  return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(max_level_)));
}

}  // namespace asos
