#pragma once

#include "renderer/film/block_result.h"
#include "renderer/session/planned_render.h"

#include <cstddef>
#include <stop_token>

namespace asos {

/// A block as a worker has rendered it, and what it took of the worker's processor.
struct TimedBlock {
  BlockResult result;
  double seconds = 0.0;
};

/// Renders a block of the plan with `settings`, which may be others than the snapshot's; its time
/// is told in its tile as well, spread over the pixels. Unfinished once a stop is requested.
[[nodiscard]] TimedBlock timed_block(const PlannedRender& render, const RenderSettings& settings,
                                     std::size_t block, const std::stop_token& stop);

}  // namespace asos
