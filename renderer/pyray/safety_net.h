#pragma once

#include "renderer/pyray/subdivide.h"

namespace asos {

/// The safety net (design section 3): where neighbouring samples meet different surfaces although
/// no boundary was found between them, splits by what samples say, as Whitted's adaptive
/// supersampling does (CGF'98 section 2.3). The leaves' weights add up to 1.
[[nodiscard]] SubdivisionOutcome split_by_samples(const Root& root, int max_level, Caster& caster);

}  // namespace asos
