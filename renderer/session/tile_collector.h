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

/// The passes over the whole picture, each better than the one before. From `first_samples` on
/// there is one for each round of samples.
enum class Pass : int {
  nothing,
  blocks,
  quarters,
  first_samples,
  final_pixels = first_samples + 32
};
/// Returns the pass of the round that ends with `samples` samples per pixel.
[[nodiscard]] constexpr Pass pass_of_samples(int samples) {
  const int doublings = std::bit_width(static_cast<unsigned>(samples)) - 1;
  return static_cast<Pass>(static_cast<int>(Pass::first_samples) + doublings);
}

/// Collects the tiles of a plan and publishes each once: those of passes over whole groups, and
/// final blocks. Any thread.
class TileCollector {
 public:
  /// `plan` has to outlive this. `on_tiles` is called when the first new tile is waiting.
  TileCollector(const WorkPlan& plan, std::function<void()> on_tiles);

  /// Returns a black coarse tile for the visible part of a group.
  [[nodiscard]] FinishedTile blank_tile(const BlockGroup& group) const;
  /// Publishes a group's tile of a pass before the final one, without blocks that are already
  /// started or final. Drops it if a better pass was faster.
  void publish_coarse(std::size_t group, Pass pass, FinishedTile&& tile);
  /// Publishes a block whose pixels have more samples; drops it if the block is started or final.
  void publish_sampled(std::size_t block, FinishedTile&& tile);
  /// Publishes a block after the first stage of its method.
  void publish_started(std::size_t block, FinishedTile&& tile);
  /// Publishes a final block. Returns true if that was the picture's last one.
  [[nodiscard]] bool finish_block(std::size_t block, BlockResult&& result);
  /// Calls `on_tiles`.
  void notify() const;

  [[nodiscard]] Reached reached() const;

  /// Returns the waiting tiles, oldest first, and clears the list.
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  /// Returns the statistics of the blocks finished so far. Once all are finished, the result does
  /// not depend on their order.
  [[nodiscard]] RenderStatistics statistics() const;

 private:
  /// The state of a group, protected by mutex_.
  struct GroupState {
    Pass published = Pass::nothing;
    std::size_t started_blocks = 0;
    std::size_t finished_blocks = 0;
    std::int64_t final_pixels = 0;
  };

  [[nodiscard]] FinishedTile visible_part(FinishedTile&& tile) const;
  void start(std::size_t block);
  void publish_block(std::size_t block, bool starts, FinishedTile&& tile);
  void put(FinishedTile&& tile);

  const WorkPlan* plan_;
  std::function<void()> on_tiles_;

  mutable std::mutex mutex_;
  std::vector<GroupState> groups_;
  std::vector<bool> started_;  // of each block
  std::size_t final_blocks_ = 0;
  std::vector<FinishedTile> finished_;
  RenderStatistics totals_;  // except for the unresolved area
  // Separate for each block, since the rounding of the sum depends on the order.
  std::vector<double> unresolved_area_;
};

}  // namespace asos
