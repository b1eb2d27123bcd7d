#pragma once

#include "renderer/samples/pixel_samples.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/tile_collector.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

namespace asos {

/// The rounds of point samples that a picture begins with, group by group: 1, 2, 4 and so on per
/// pixel. A method with the same number of samples in every pixel uses its own samples
/// (MethodRow::places), and its picture is complete after the rounds. For other methods the rounds
/// use Sobol points. Any number of threads.
class SampleRounds {
 public:
  /// Maximal number of rounds before the blocks of a method: up to 2^10 samples per pixel, while
  /// nothing better is available.
  static constexpr int most_rounds = 11;

  explicit SampleRounds(const PlannedRender& render);

  /// Returns whether the rounds produce the final pixels.
  [[nodiscard]] bool make_the_picture() const { return own_; }
  /// Returns the samples per pixel after each round.
  [[nodiscard]] const std::vector<int>& rounds() const { return rounds_; }

  /// Orders the groups of later rounds by the changes of their pixels in the latest round, largest
  /// first. To be called between two rounds; only the first call for a round counts.
  void put_what_moves_first(std::size_t next_round);
  /// Renders groups of a round, given by its index in `rounds`, until none is left or `stop` is
  /// requested. Times count for pass `pass`. Returns true if this finished the picture.
  bool work(const PlannedRender& render, std::size_t round, std::size_t pass, TileCollector& tiles,
            RunClock& clock, const std::stop_token& stop);
  /// Waits until all groups of a round are done; false once `stop` is requested.
  [[nodiscard]] bool wait_for(std::size_t round, const std::stop_token& stop);

  /// Returns the processor time, in seconds, of all rounds up to this one, which must be complete.
  [[nodiscard]] double seconds_up_to(std::size_t round) const;
  /// Frees the sums of all groups. Only when no thread works on a round or calls `moved`.
  void release();
  /// Returns the memory of the kept sums.
  [[nodiscard]] std::size_t bytes() const;

  /// Returns, for each block of the plan, how much its pixels changed in their latest round: the
  /// sum of PixelSamples::moved. Blocks with large changes are far from converged.
  [[nodiscard]] std::vector<double> moved(const WorkPlan& plan) const;

 private:
  struct Group {
    mutable std::mutex mutex;
    bool done = false;  // its samples are no longer needed
    std::optional<PixelSamples> pixels;
    std::optional<PixelSamples> unlit_share, unlit_colour;
    double seconds = 0.0;
  };
  struct Done {
    std::size_t groups = 0;
    double seconds = 0.0;
  };
  /// Returns none if the group is done: another thread has rendered a later round.
  [[nodiscard]] std::optional<BlockResult> advance(const PlannedRender& render, std::size_t group,
                                                   int samples, double& seconds,
                                                   const std::stop_token& stop);
  static void drop_samples(Group& group);

  RenderSettings settings_;
  bool own_;
  std::vector<int> rounds_;
  std::vector<Group> groups_;
  std::vector<std::atomic<std::size_t>> next_;  // of each round
  mutable std::mutex mutex_;
  std::condition_variable_any finished_;
  std::vector<Done> done_;          // of each round
  std::size_t ordered_round_ = 0;   // round of the last change of order_
  std::vector<std::size_t> order_;  // of groups
};

}  // namespace asos
