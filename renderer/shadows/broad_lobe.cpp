#include "renderer/shadows/broad_lobe.h"

#include "renderer/shading/reflected_light.h"

#include <algorithm>

namespace asos {

bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit, const Visibility& seen) {
  const Budget& budget = block.rules.budget;
  if (!budget.refines() || budget.max_level == 0 || !is_broad(lit)) return false;
  const Visibility both = seen * (1.0 - seen);
  const auto share = static_cast<float>(std::max({both.x, both.y, both.z}));
  const float tolerance = budget.for_samples().tolerance;
  return share * lit.highlight > tolerance && share * spread_over(lit) > tolerance;
}

}  // namespace asos
