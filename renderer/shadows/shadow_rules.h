#pragma once

#include "renderer/settings/choices.h"

namespace asos {

/// What shadow pyrays go by.
struct ShadowRules {
  ShadowQuality quality = ShadowQuality::refined;
  int divisions = 2;  ///< n
  int max_level = 3;  ///< MAX of the parent pyray; shadow pyrays get what its levels leave
  double eps = 0.0;   ///< of the parent's root
  bool exact_leaves = true;
  /// Some surfaces of the scene have holes, or let more light through here than there.
  bool see_through = true;
  /// By how much a leaf may be off the mean of its patch before it is split: refined only.
  float most_uneven = 0.0f;
};

}  // namespace asos
