#include "renderer/shadows/broad_lobe.h"

#include "renderer/shading/reflected_light.h"

#include <algorithm>

namespace asos {

bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit, const Visibility& seen) {
  const ErrorBudget& error_budget = block.rules.error_budget;
  if (!error_budget.refines_leaves() || !is_broad(lit)) return false;
  const Visibility both = seen * (1.0 - seen);
  const auto share = static_cast<float>(std::max({both.x, both.y, both.z}));
  const float tolerance = error_budget.tolerance;
  return share * lit.highlight > tolerance && share * spread_over(lit) > tolerance;
}

}  // namespace asos
