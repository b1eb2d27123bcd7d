#pragma once

#include "renderer/film/block_result.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"

#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace asos {

/// Over all of the picture, each better than the one before. Between `centres` and `final_pixels`
/// there is one for each MAX.
enum class Pass : int {
  nothing,
  blocks,
  quarters,
  centres,
  first_level,
  final_pixels = first_level + max_level_limit + 1
};
[[nodiscard]] constexpr Pass pass_of_level(int level) {
  return static_cast<Pass>(static_cast<int>(Pass::first_level) + level);
}

/// Collects what is rendered of a plan: puts the blocks of the final pass together to tiles, a
/// group's each, and publishes them and those of coarse passes. Any thread.
class TileCollector {
 public:
  /// `plan` has to outlive this. `on_tiles` is called when tiles wait that did not before.
  TileCollector(const WorkPlan& plan, std::function<void()> on_tiles);

  /// A black coarse tile of what is visible of a group.
  [[nodiscard]] FinishedTile blank_tile(const BlockGroup& group) const;
  /// Publishes a group's tile of a pass before the final one, with what is final of it, or drops it
  /// where a better one was quicker.
  void publish_coarse(std::size_t group, Pass pass, FinishedTile&& tile);
  /// Takes a block of the final pass, and publishes its group's tile if it was the last of them.
  /// True if that was the picture's last tile.
  [[nodiscard]] bool finish_block(std::size_t block, BlockResult&& result);
  /// Calls `on_tiles`.
  void notify() const;

  /// Publishes the final blocks of the groups that are not finished, each as a tile. Once the
  /// workers have ended.
  void publish_unfinished();
  [[nodiscard]] Reached reached() const;

  /// The tiles that wait, oldest first; none waits then.
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  /// Those of the blocks finished so far; once all are, their order does not matter.
  [[nodiscard]] RenderStatistics statistics() const;

 private:
  /// A group's state; all of it under mutex_.
  struct GroupState {
    Pass published = Pass::nothing;
    std::size_t finished_blocks = 0;
    std::int64_t final_pixels = 0;
    double unresolved_area = 0.0;
    std::vector<BlockResult> blocks;  // of the final pass, until all are there
  };

  [[nodiscard]] std::vector<BlockResult> add_block(std::size_t block, BlockResult&& result);
  [[nodiscard]] bool publish(std::size_t group, Pass pass, FinishedTile&& tile);

  const WorkPlan* plan_;
  std::function<void()> on_tiles_;

  mutable std::mutex mutex_;
  std::vector<GroupState> groups_;
  std::size_t final_groups_ = 0;
  std::vector<FinishedTile> finished_;
  RenderStatistics totals_;  // but for the unresolved area
};

}  // namespace asos
