#pragma once

#include "renderer/session/planned_render.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <cstddef>
#include <stop_token>

namespace asos {

/// The coarse pictures in a window before each pixel has a sample: first one sample at the centre
/// of each square of 8 pixels a side, then one for each quarter of it. Keeps track of the remaining
/// groups; any number of threads.
class CoarsePasses {
 public:
  /// Renders into `tiles` until no group is left or `stop` is requested. There is no barrier
  /// between the passes: a thread that finds no more work in one pass starts the next, and late
  /// results are dropped.
  void work(const PlannedRender& render, TileCollector& tiles, const std::stop_token& stop);

 private:
  void work_middles(const PlannedRender& render, Pass pass, TileCollector& tiles,
                    const std::stop_token& stop);

  std::atomic<std::size_t> next_blocks_{0};  // groups
  std::atomic<std::size_t> next_quarters_{0};
};

}  // namespace asos
