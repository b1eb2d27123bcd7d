#pragma once

#include "renderer/samples/unfinished_block.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/sample_rounds.h"
#include "renderer/session/step_queue.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

namespace asos {

/// Renders the final pixels of a method that renders block by block, in the order of a StepQueue.
/// Until a block is rendered, its pixels take more samples where that reduces the error sooner.
/// A method with one stage finishes its blocks at once. Any number of threads.
class RenderSteps {
 public:
  RenderSteps(const PlannedRender& render, SampleRounds& samples);

  /// Orders the steps by the samples so far; only the first call counts. To be called after the
  /// last round of samples, or not at all.
  void begin();
  /// See StepQueue.
  void prefer(const PixelRect& part);
  /// Returns whether the boundaries that the method uses are known, and begins to search the first
  /// unknown ones.
  [[nodiscard]] static bool blocks_can_start(const PlannedRender& render);
  /// Does steps until none is left, `stop` is requested, or the boundaries that the method needs
  /// are missing. Returns true if that finished the picture.
  bool work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
            const std::stop_token& stop);

 private:
  struct Started {
    std::unique_ptr<UnfinishedBlock> rest;
    std::vector<glm::vec4> unlit;  // see FinishedTile::unlit
    double seconds = 0.0;
  };
  [[nodiscard]] std::optional<Step> next(const PlannedRender& render, RunClock& clock,
                                         const std::stop_token& stop);
  [[nodiscard]] bool perform(const PlannedRender& render, const Step& step, TileCollector& tiles,
                             RunClock& clock, const std::stop_token& stop);
  [[nodiscard]] bool start(const PlannedRender& render, std::size_t block, TileCollector& tiles,
                           const std::stop_token& stop);
  [[nodiscard]] bool finish(const PlannedRender& render, std::size_t block, TileCollector& tiles,
                            const std::stop_token& stop);

  SampleRounds& samples_;
  std::size_t most_bytes_;
  std::atomic<std::size_t> bytes_{0};  // memory of started blocks
  std::vector<Started> started_;       // by block; those of a step belong to its thread
  mutable std::mutex mutex_;           // protects all that follows
  std::condition_variable_any changed_;
  StepQueue queue_;
  int running_ = 0;       // steps
  std::size_t done_ = 0;  // steps
};

}  // namespace asos
