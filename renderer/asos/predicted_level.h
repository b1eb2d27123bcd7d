#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/film/split_outlook.h"
#include "renderer/settings/settings.h"

namespace asos {

/// The deepest level that a pixel would be split to by other settings, from what it told when it
/// was rendered by `rendered`: 0 to MAX of `asked`. Only EPS and MAX may differ. Some 20 ns a
/// pixel, so that a map of a whole picture follows a slider. An estimate: each level is taken to
/// leave a quarter of a leaf's error and half of the marginal area (CGF'98 section 6.2), and
/// samples to go with the tolerance as Allowance::samples says.
class LevelPrediction {
 public:
  LevelPrediction(const RenderSettings& rendered, const RenderSettings& asked);

  /// `cause`: the one that the pixel was split for.
  [[nodiscard]] int level_of(const SplitOutlook& pixel, SplitCause cause = SplitCause::none) const;

 private:
  int max_level_;
  double eps_;               // asked for
  double tolerance_before_;  // of what was rendered
  double tolerance_;         // of what is asked for
  double more_samples_;      // times as many
  double tangle_samples_;    // of a pixel with too many edges
  double most_samples_;
};

}  // namespace asos
