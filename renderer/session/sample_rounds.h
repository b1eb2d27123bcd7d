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

/// The rounds of point samples that a picture begins with, group by group: 1, 2, 4 and so on a
/// pixel, by the method's own samples where it takes as many in every pixel (MethodRow::places),
/// and else by Sobol points. Methods of the first kind end with them. Any number of threads.
class SampleRounds {
 public:
  /// Rounds that a method may begin with which does not end so: up to 2^10 samples a pixel, while
  /// nothing better is to be had.
  static constexpr int most_rounds = 11;

  explicit SampleRounds(const PlannedRender& render);

  /// Whether they end with the picture's final pixels.
  [[nodiscard]] bool make_the_picture() const { return own_; }
  /// Samples of a pixel after each round.
  [[nodiscard]] const std::vector<int>& rounds() const { return rounds_; }

  /// From now on, groups come in the order in which their pixels moved in the latest round, those
  /// first that moved most. Once that is there, and before the next one; only the first call counts
  /// of those of a round.
  void put_what_moves_first(std::size_t next_round);
  /// Takes groups of a round, by its place in `rounds`, until none is left or `stop` is requested.
  /// Times count for pass `pass`. True if this finished the picture.
  bool work(const PlannedRender& render, std::size_t round, std::size_t pass, TileCollector& tiles,
            RunClock& clock, const std::stop_token& stop);
  /// Waits until all groups of a round are there; false once `stop` is requested.
  [[nodiscard]] bool wait_for(std::size_t round, const std::stop_token& stop);

  /// The processor's seconds of all rounds up to this one, once all of it is there.
  [[nodiscard]] double seconds_up_to(std::size_t round) const;
  /// Frees the sums of all groups. Once no thread works on a round or asks for `moved`.
  void release();
  /// Memory of the sums that are kept.
  [[nodiscard]] std::size_t bytes() const;

  /// How far the pixels of each block of the plan moved in their latest round: the sum of
  /// PixelSamples::moved. What moved much is far from its end.
  [[nodiscard]] std::vector<double> moved(const WorkPlan& plan) const;

 private:
  struct Group {
    mutable std::mutex mutex;
    bool done = false;  // nobody asks for its samples any more
    std::optional<PixelSamples> pixels;
    std::optional<PixelSamples> unlit_share, unlit_colour;
    double seconds = 0.0;
  };
  struct Done {
    std::size_t groups = 0;
    double seconds = 0.0;
  };
  /// Nothing where the group is done: another thread has taken a later round.
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
  std::size_t ordered_round_ = 0;   // the one that order_ was last changed for
  std::vector<std::size_t> order_;  // of groups
};

}  // namespace asos
