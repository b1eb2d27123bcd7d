#pragma once

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

  [[nodiscard]] int level_of(const SplitOutlook& pixel) const;

 private:
  int max_level_;
  double eps_;           // asked for
  double tolerance_;     // of that
  double more_samples_;  // times as many
  double most_samples_;
};

}  // namespace asos
