#pragma once

#include "renderer/pyray/subdivide.h"
#include "renderer/settings/settings.h"

namespace asos {

/// How the settings ask for pixels to be subdivided.
[[nodiscard]] inline SubdivisionRules rules_of(const RenderSettings& settings) {
  SubdivisionRules rules;
  rules.max_level = settings.asos.max_level;
  rules.eps = settings.asos.eps;
  rules.rule = settings.asos.rule;
  rules.detection = settings.asos.detect;
  rules.exact_leaves = settings.asos.leaf == Leaf::exact;
  rules.jitter = settings.asos.jitter;
  return rules;
}

}  // namespace asos
