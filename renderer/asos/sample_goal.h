#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/samples/region_sampler.h"

#include <cstdint>

namespace asos {

/// What is sampled, which says how well: what splitting would make even as well, as that would;
/// noise, such as bumpy and bent mirrors and tangles are full of, as it can be afforded.
enum class Sampled { smooth, noisy };

/// How far samples of a part of a root go, of at least `fewest`; of what mirrors show `few_samples`
/// do.
[[nodiscard]] RegionSampler::Goal sample_goal(const EyeContext& eye, double weight,
                                              std::uint32_t fewest, Sampled what);

/// So few samples are right where there are many such parts, or the part is only one of what a
/// mirror shows.
inline constexpr std::uint32_t few_samples = 4;
/// So many tell how far their mean may be off, which matters for what is no small part of its
/// pixel: a smaller one takes as many as it would have of a pixel's 256, however they agree.
inline constexpr std::uint32_t enough_samples = 16;
[[nodiscard]] std::uint32_t enough_samples_for(const Budget& budget, double weight);

}  // namespace asos
