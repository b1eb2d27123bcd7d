#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/samples/region_sampler.h"

#include <cstdint>

namespace asos {

/// Returns the sampling goal of a part of a root. Sampling starts with the pilot's number, or
/// `fewest` if larger. It ends at the number that MAX allows, or once the standard error is within
/// the allowance.
[[nodiscard]] RegionSampler::Goal sample_goal(const EyeContext& eye, double weight,
                                              std::uint32_t fewest = 1);
/// Returns the goal for another allowance than that of the roots.
[[nodiscard]] RegionSampler::Goal sample_goal(const ErrorBudget& error_budget, double weight,
                                              std::uint32_t fewest);

}  // namespace asos
