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

/// Renders the final pixels of a method that renders block by block. First comes a trial: a few
/// blocks spread over the picture, whose time predicts that of all blocks. Then all others are
/// started, in the order of their changes in the last round of samples. Finally they are finished
/// in the order of their gain. A method with one stage finishes its blocks at once. Any number of
/// threads.
class FinalBlocks {
 public:
  /// Memory limit for started blocks, per pixel of the picture. Blocks beyond it are finished at
  /// once.
  static constexpr std::size_t bytes_a_pixel = 400;

  /// `pass`: the number of the first stage for the clock; that of the second stage is one more.
  FinalBlocks(const PlannedRender& render, std::size_t pass);

  /// Renders the blocks of the trial, until they took more than `enough` seconds or none is left.
  /// Returns true if that finished the picture.
  bool work_trial(const PlannedRender& render, double enough, TileCollector& tiles, RunClock& clock,
                  const std::stop_token& stop);
  /// Waits for the end of the trial; false once `stop` is requested.
  [[nodiscard]] bool wait_for_trial(const std::stop_token& stop);
  /// Returns the expected processor time of all blocks, in seconds, from those of the trial.
  [[nodiscard]] double expected_seconds() const;

  /// Orders the other blocks by falling `gain` (one value per block), with a few blocks spread over
  /// the picture in between. Only the first call has an effect. Without it all blocks are in spread
  /// order.
  void set_gains(std::span<const double> gain);
  /// Renders the other blocks until none is left or `stop` is requested. Returns true if that
  /// finished the picture.
  bool work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
            const std::stop_token& stop);

 private:
  struct Started {
    std::size_t block = 0;
    std::unique_ptr<UnfinishedBlock> rest;
    std::vector<glm::vec4> unlit;  // see FinishedTile::unlit
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
  std::vector<std::size_t> order_;  // blocks of the trial first
  std::size_t trial_;               // number of blocks in the trial
  std::size_t most_bytes_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> bytes_{0};  // memory of started blocks
  mutable std::mutex mutex_;           // protects all that follows
  std::condition_variable_any changed_;
  bool ordered_ = false;
  std::vector<double> seconds_;  // of the trial's blocks; negative: not known yet
  double enough_ = 0.0;          // time limit of the trial, in seconds
  std::size_t handed_out_ = 0;   // blocks of the trial given to threads
  std::size_t left_to_start_ = 0;
  std::vector<Started> started_;
  bool sorted_ = false;
  std::atomic<std::size_t> next_started_{0};
};

}  // namespace asos
