#pragma once

#include "renderer/film/block_result.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"

#include <bit>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace asos {

/// Over all of the picture, each better than the one before. From `first_samples` on there is one
/// for each round of samples.
enum class Pass : int {
  nothing,
  blocks,
  quarters,
  first_samples,
  final_pixels = first_samples + 32
};
/// The pass of the round that ends with `samples` samples per pixel.
[[nodiscard]] constexpr Pass pass_of_samples(int samples) {
  const int doublings = std::bit_width(static_cast<unsigned>(samples)) - 1;
  return static_cast<Pass>(static_cast<int>(Pass::first_samples) + doublings);
}

/// Collects what is rendered of a plan and publishes it, each tile once: those of passes over whole
/// groups, and final blocks. Any thread.
class TileCollector {
 public:
  /// `plan` has to outlive this. `on_tiles` is called when tiles wait that did not before.
  TileCollector(const WorkPlan& plan, std::function<void()> on_tiles);

  /// A black coarse tile of what is visible of a group.
  [[nodiscard]] FinishedTile blank_tile(const BlockGroup& group) const;
  /// Publishes a group's tile of a pass before the final one, but for blocks of it that were
  /// started or are final, or drops it where a better pass was quicker.
  void publish_coarse(std::size_t group, Pass pass, FinishedTile&& tile);
  /// Publishes a block that its method has started.
  void publish_started(std::size_t block, FinishedTile&& tile);
  /// Publishes a final block. True if that was the picture's last one.
  [[nodiscard]] bool finish_block(std::size_t block, BlockResult&& result);
  /// Calls `on_tiles`.
  void notify() const;

  [[nodiscard]] Reached reached() const;

  /// The tiles that wait, oldest first; none waits then.
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  /// Those of the blocks finished so far; once all are, their order does not matter.
  [[nodiscard]] RenderStatistics statistics() const;

 private:
  /// A group's state; all of it under mutex_.
  struct GroupState {
    Pass published = Pass::nothing;
    std::size_t started_blocks = 0;
    std::size_t finished_blocks = 0;
    std::int64_t final_pixels = 0;
  };

  [[nodiscard]] FinishedTile visible_part(FinishedTile&& tile) const;
  void start(std::size_t block);
  void put(FinishedTile&& tile);

  const WorkPlan* plan_;
  std::function<void()> on_tiles_;

  mutable std::mutex mutex_;
  std::vector<GroupState> groups_;
  std::vector<bool> started_;  // of each block
  std::size_t final_blocks_ = 0;
  std::vector<FinishedTile> finished_;
  RenderStatistics totals_;              // but for the unresolved area
  std::vector<double> unresolved_area_;  // of each block: what adds up in no other order
};

}  // namespace asos
