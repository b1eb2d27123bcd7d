#include "renderer/shadows/broad_lobe.h"

#include "renderer/shading/reflected_light.h"

#include <algorithm>

namespace asos {

bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit, const Visibility& seen) {
  const Allowance& allowance = block.rules.allowance;
  if (!allowance.refines_leaves() || !is_broad(lit)) return false;
  const Visibility both = seen * (1.0 - seen);
  const auto share = static_cast<float>(std::max({both.x, both.y, both.z}));
  const float tolerance = allowance.tolerance;
  return share * lit.highlight > tolerance && share * spread_over(lit) > tolerance;
}

}  // namespace asos
