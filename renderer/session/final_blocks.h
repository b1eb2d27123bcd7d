#pragma once

#include "renderer/samples/unfinished_block.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// The pixels of a method that renders block by block. First a few blocks that are spread over the
/// picture: their time tells what all of them take. Then all others are started, from those on that
/// the rounds of samples left furthest from their end; and then finished, from those on where work
/// gains most. A method that has one stage finishes them at once. Any number of threads.
class FinalBlocks {
 public:
  /// Memory of blocks that are started, for each pixel of the picture: what is beyond it is
  /// finished at once.
  static constexpr std::size_t bytes_a_pixel = 400;

  /// `pass`: the number of the first stage for the clock; the second one's follows.
  FinalBlocks(const PlannedRender& render, std::size_t pass);

  /// Renders the few, until they took more than `enough` seconds or none is left. True if that
  /// finished the picture.
  bool work_trial(const PlannedRender& render, double enough, TileCollector& tiles, RunClock& clock,
                  const std::stop_token& stop);
  /// Waits for them; false once `stop` is requested.
  [[nodiscard]] bool wait_for_trial(const std::stop_token& stop);
  /// What all blocks take, in the processor's seconds, as the few tell.
  [[nodiscard]] double expected_seconds() const;

  /// The other blocks begin with those of the largest `gain`, one a block, but for a few in between
  /// that are spread over the picture; only the first call counts. Without it all are spread.
  void set_gains(std::span<const double> gain);
  /// Renders the other blocks until none is left or `stop` is requested. True if that finished the
  /// picture.
  bool work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
            const std::stop_token& stop);

 private:
  struct Started {
    std::size_t block = 0;
    std::unique_ptr<UnfinishedBlock> rest;
    std::vector<glm::vec4> unlit;  // as of the tile
    double gain = 0.0;
    double seconds = 0.0;
  };
  [[nodiscard]] Started start(const PlannedRender& render, std::size_t block, bool keep,
                              TileCollector& tiles, RunClock& clock, const std::stop_token& stop,
                              bool& finished_picture);
  [[nodiscard]] bool finish(const PlannedRender& render, Started& started, TileCollector& tiles,
                            RunClock& clock, const std::stop_token& stop);
  [[nodiscard]] bool finish_all(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                                const std::stop_token& stop);
  [[nodiscard]] bool trial_is_over() const;

  std::size_t pass_;
  std::vector<std::size_t> order_;  // those of the trial first
  std::size_t trial_;               // so many of these
  std::size_t most_bytes_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> bytes_{0};  // of blocks that are started
  mutable std::mutex mutex_;           // of all that follows
  std::condition_variable_any changed_;
  bool ordered_ = false;
  std::vector<double> seconds_;  // of the trial's blocks; negative: not known yet
  double enough_ = 0.0;          // of it
  std::size_t handed_out_ = 0;   // of it
  std::size_t left_to_start_ = 0;
  std::vector<Started> started_;
  bool sorted_ = false;
  std::atomic<std::size_t> next_started_{0};
};

}  // namespace asos
