#pragma once

#include "renderer/pyray/subdivide.h"

namespace asos {

/// The safety net (design section 3): handles neighbouring samples on different surfaces without a
/// boundary between them. Splits by samples, as Whitted's adaptive supersampling does (CGF'98
/// section 2.3). The leaves' weights add up to 1.
[[nodiscard]] SubdivisionOutcome split_by_samples(const Root& root, int max_level, Caster& caster);

}  // namespace asos
