#pragma once

#include "renderer/session/planned_render.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <cstddef>
#include <stop_token>

namespace asos {

/// The pictures that a window shows before there is a sample for each pixel: first one in the
/// middle of each square of 8 pixels a side, then of each quarter of one. Knows which groups are
/// still to do; any number of threads.
class CoarsePasses {
 public:
  /// Renders into `tiles` until no group is left or `stop` is requested. No barrier stands between
  /// the passes: who runs out of one goes on to the next, and what is brought too late is dropped.
  void work(const PlannedRender& render, TileCollector& tiles, const std::stop_token& stop);

 private:
  void work_middles(const PlannedRender& render, Pass pass, TileCollector& tiles,
                    const std::stop_token& stop);

  std::atomic<std::size_t> next_blocks_{0};  // groups
  std::atomic<std::size_t> next_quarters_{0};
};

}  // namespace asos
