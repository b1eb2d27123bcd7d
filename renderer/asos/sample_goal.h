#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/samples/region_sampler.h"

#include <cstdint>

namespace asos {

/// How far samples of a part of a root go: from the pilot's number, or `fewest` if those are more,
/// to the most that MAX allows, until their standard error is within the allowance.
[[nodiscard]] RegionSampler::Goal sample_goal(const EyeContext& eye, double weight,
                                              std::uint32_t fewest = 1);
/// The same by another allowance than that of the roots.
[[nodiscard]] RegionSampler::Goal sample_goal(const Allowance& allowance, double weight,
                                              std::uint32_t fewest);

}  // namespace asos
