#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/film/split_prediction_data.h"
#include "renderer/settings/settings.h"

namespace asos {

/// Predicts how a pixel is split with other settings, from the statistics of its rendering
/// with `rendered`: 0 to MAX of `asked`. Only EPS and MAX may differ. Costs about 20 ns per pixel,
/// so that a map of a whole picture follows a slider. It assumes that each level leaves a quarter
/// of a leaf's error and half of the marginal area (CGF'98 section 6.2), and that samples follow
/// ErrorBudget::samples.
class LevelPrediction {
 public:
  LevelPrediction(const RenderSettings& rendered, const RenderSettings& asked);

  /// Returns the deepest level of its cells.
  [[nodiscard]] int level_of(const SplitPredictionData& pixel) const;
  /// Returns the number of its samples; 0: it is not sampled for its shading. `cause` is the cause
  /// of the pixel's split.
  [[nodiscard]] std::uint32_t samples_of(const SplitPredictionData& pixel,
                                         SplitCause cause = SplitCause::none) const;

 private:
  int max_level_;
  double eps_;               // requested
  double tolerance_before_;  // with the settings of the rendering
  double tolerance_;         // with the requested settings
  double more_samples_;      // requested samples divided by the rendering's samples
  double tangle_samples_;    // samples of a pixel with too many edges
  double most_samples_;
};

}  // namespace asos
