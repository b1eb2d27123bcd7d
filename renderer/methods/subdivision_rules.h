#pragma once

#include "renderer/methods/settings.h"
#include "renderer/pyray/subdivide.h"

namespace asos {

/// How the settings ask for pixels to be subdivided.
[[nodiscard]] inline SubdivisionRules rules_of(const RenderSettings& settings) {
  SubdivisionRules rules;
  rules.max_level = settings.max_level;
  rules.eps = settings.eps;
  rules.rule = settings.rule;
  rules.detection = settings.detect;
  rules.exact_leaves = settings.leaf == Leaf::exact;
  rules.jitter = settings.jitter;
  return rules;
}

}  // namespace asos
