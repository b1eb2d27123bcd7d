#pragma once

#include "renderer/samples/block_job.h"

namespace asos {

struct MethodRow;

/// Renders a block by a method that shows one moment at a time: the mean over the moments of
/// `job.motion` by the trapezoidal rule. Blocks in which nothing moves show the middle moment. The
/// time of other blocks is bisected until the deviation of an interval from a linear course, times
/// its part of the exposure, is below 2 EPS: an edge then causes an error of up to EPS / 2. Blocks
/// that a moving surface may cross are also bisected while it moves by more than half a block.
/// Where surfaces move by more than Exposure::longest_step pixels from one moment to the next,
/// sobol_adaptive renders the block instead. The cause of pixels that change in between is
/// SplitCause::motion.
[[nodiscard]] BlockResult render_over_time(const BlockJob& job, const MethodRow& row);

}  // namespace asos
