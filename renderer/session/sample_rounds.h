#pragma once

#include "renderer/samples/pixel_samples.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/step_queue.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// The point samples that a picture begins with, in rounds over all groups: 1, 2, 4 and so on per
/// pixel. A method with the same number of samples in every pixel uses its own samples
/// (MethodRow::places), and its picture is complete after the rounds. For other methods there are
/// few rounds, of Sobol points; then single pixels continue. Any number of threads.
class SampleRounds {
 public:
  explicit SampleRounds(const PlannedRender& render);

  /// Returns whether the rounds produce the final pixels.
  [[nodiscard]] bool make_the_picture() const { return own_; }
  /// Returns the samples per pixel after each round.
  [[nodiscard]] const std::vector<int>& rounds() const { return rounds_; }

  /// Orders the groups of a round by the changes of their pixels in the rounds before, largest
  /// first. Waits until those are complete; false once `stop` is requested. Only the first call for
  /// a round counts, and only before a later round was ordered: a thread that comes late must not
  /// change what the others use.
  [[nodiscard]] bool put_what_moves_first(std::size_t round, const std::stop_token& stop);
  /// Renders groups of a round, given by its index in `rounds`, until none is left or `stop` is
  /// requested. Returns true if this finished the picture.
  bool work(const PlannedRender& render, std::size_t round, TileCollector& tiles, RunClock& clock,
            const std::stop_token& stop);
  /// Takes the groups that touch this part of the picture to their last round before all others,
  /// if the rounds produce the final pixels.
  void prefer(const WorkPlan& plan, const PixelRect& part);
  /// Waits until all groups have finished the rounds before this one; false once `stop` is
  /// requested.
  [[nodiscard]] bool wait_for_rounds(std::size_t before, const std::stop_token& stop);

  /// Takes each of these pixels to four times its number of samples, after the last round, and
  /// publishes the blocks that hold them. Threads may call this for different pixels at a time.
  /// Returns the pixels' samples; the result is to be dropped once `stop` is requested.
  [[nodiscard]] std::vector<StepQueue::Sampled> continue_pixels(
      const PlannedRender& render, std::span<const PlannedPixel> pixels, TileCollector& tiles,
      const std::stop_token& stop);
  /// Returns the samples of a group. Only after its last round, and while none of its pixels
  /// continues.
  [[nodiscard]] const PixelSamples& pixels(std::size_t group) const {
    return *groups_[group].pixels;
  }
  /// Returns the processor time of a group's rounds, in seconds.
  [[nodiscard]] double seconds(std::size_t group) const { return groups_[group].seconds; }

  /// Returns the memory of the kept sums.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Group {
    mutable std::mutex mutex;
    bool done = false;  // its samples are no longer needed
    std::optional<PixelSamples> pixels;
    std::optional<PixelSamples> unlit_share, unlit_colour;
    double seconds = 0.0;
    // Under SampleRounds::mutex_: samples per pixel that are counted, and seconds for each of the
    // latest ones.
    int taken = 0;
    double pace = 0.0;
  };
  using PassOfGroup = std::optional<PixelSamples> Group::*;
  /// Pixels that continue their samples of one pass.
  struct Continued {
    std::vector<PlannedPixel> places;
    std::vector<ContinuedPixel> pixels;
    std::vector<LayerSum> layers;
    std::vector<int> ends;
  };
  [[nodiscard]] Continued continued(const PlannedRender& render,
                                    std::span<const PlannedPixel> pixels, PassOfGroup pass,
                                    const RenderSettings& settings,
                                    const std::stop_token& stop) const;
  void put(const PlannedRender& render, const Continued& done, PassOfGroup pass);
  [[nodiscard]] FinishedTile tile(const PlannedRender& render, const Group& group,
                                  const PixelRect& part) const;
  /// Returns none if the group is done: another thread has rendered a later round.
  [[nodiscard]] std::optional<BlockResult> advance(const PlannedRender& render, std::size_t group,
                                                   int samples, double& seconds,
                                                   const std::stop_token& stop);
  static void drop_samples(Group& group);
  [[nodiscard]] std::optional<std::size_t> take_preferred();
  [[nodiscard]] bool render(const PlannedRender& render, std::size_t group, std::size_t round,
                            TileCollector& tiles, RunClock& clock, const std::stop_token& stop);
  void count(std::size_t group, int samples, double seconds, RunClock& clock);

  RenderSettings settings_;
  bool own_;
  std::vector<int> rounds_;
  std::vector<Group> groups_;
  std::vector<std::atomic<std::size_t>> next_;  // of each round
  mutable std::mutex mutex_;
  std::condition_variable_any finished_;
  std::size_t done_ = 0;            // groups of all rounds
  std::size_t paced_ = 0;           // groups with a pace
  double pace_ = 0.0;               // sum of all paces
  double left_ = 0.0;               // seconds of their further rounds, at their paces
  std::size_t ordered_round_ = 0;   // the latest round that changed order_
  std::vector<std::size_t> order_;  // of groups
  std::vector<std::size_t> preferred_;
};

}  // namespace asos
