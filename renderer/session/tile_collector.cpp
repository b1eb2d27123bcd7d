#include "renderer/session/tile_collector.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

/// For the coverage of a part that tells any.
void make_room(const FinishedTile& part, FinishedTile& whole) {
  if (!part.coverage.empty()) whole.coverage.resize(whole.radiance.size(), 1.0f);
}

}  // namespace

TileCollector::TileCollector(const WorkPlan& plan, std::function<void()> on_tiles)
    : plan_(&plan), on_tiles_(std::move(on_tiles)), groups_(plan.groups.size()) {}

FinishedTile TileCollector::blank_tile(const BlockGroup& group) const {
  FinishedTile tile;
  tile.rect = intersection(group.rect, plan_->visible);
  const std::size_t pixels =
      static_cast<std::size_t>(tile.rect.width) * static_cast<std::size_t>(tile.rect.height);
  tile.radiance.resize(pixels, glm::vec3(0.0f));
  tile.split_level.resize(pixels, 0);
  tile.cause.resize(pixels, SplitCause::none);
  tile.coarse = true;
  return tile;
}

void TileCollector::publish_coarse(std::size_t group, Pass pass, FinishedTile&& tile) {
  {
    const std::lock_guard lock(mutex_);
    for (const BlockResult& block : groups_[group].blocks) {
      make_room(block.tile, tile);
      if (block.tile.radiance.empty()) continue;
      copy_pixels(block.tile, tile);
    }
  }
  (void)publish(group, pass, std::move(tile));
}

void TileCollector::publish_unfinished() {
  const std::lock_guard lock(mutex_);
  for (GroupState& group : groups_) {
    for (BlockResult& block : group.blocks) {
      if (block.tile.radiance.empty()) continue;
      FinishedTile& tile = finished_.emplace_back();
      tile.rect = intersection(block.tile.rect, plan_->visible);
      const auto pixels = static_cast<std::size_t>(tile.rect.width * tile.rect.height);
      tile.radiance.resize(pixels);
      tile.split_level.resize(pixels);
      tile.cause.resize(pixels);
      tile.rays.resize(pixels);
      tile.seconds.resize(pixels);
      if (!block.tile.coverage.empty()) tile.coverage.resize(pixels);
      copy_pixels(block.tile, tile);
      tile.rect.x -= plan_->visible.x;
      tile.rect.y -= plan_->visible.y;
    }
    group.blocks.clear();
  }
}

bool TileCollector::finish_block(std::size_t block, BlockResult&& result) {
  const std::vector<BlockResult> whole = add_block(block, std::move(result));
  if (whole.empty()) return false;
  const std::size_t group = plan_->blocks[block].group;
  FinishedTile tile = blank_tile(plan_->groups[group]);
  tile.coarse = false;
  tile.rays.resize(tile.radiance.size());
  tile.seconds.resize(tile.radiance.size());
  for (const BlockResult& one : whole) {
    make_room(one.tile, tile);
    copy_pixels(one.tile, tile);
  }
  return publish(group, Pass::final_pixels, std::move(tile));
}

// The blocks of its group where it is the last of them, else none.
std::vector<BlockResult> TileCollector::add_block(std::size_t block, BlockResult&& result) {
  const std::size_t index = plan_->blocks[block].group;
  const BlockGroup& group = plan_->groups[index];
  const std::lock_guard lock(mutex_);
  // Integers add up in any order; the one sum that does not waits for its group.
  RenderStatistics counts = result.statistics;
  counts.unresolved_area = 0.0;
  totals_ += counts;
  GroupState& state = groups_[index];
  const PixelRect seen = intersection(result.tile.rect, plan_->visible);
  state.final_pixels += static_cast<std::int64_t>(seen.width) * seen.height;
  state.blocks.resize(group.block_count);
  state.blocks[block - group.first_block] = std::move(result);
  if (++state.finished_blocks < group.block_count) return {};
  for (const BlockResult& one : state.blocks)
    state.unresolved_area += one.statistics.unresolved_area;
  return std::exchange(state.blocks, {});
}

// True for the last tile of the final pass.
bool TileCollector::publish(std::size_t group, Pass pass, FinishedTile&& tile) {
  tile.rect.x -= plan_->visible.x;
  tile.rect.y -= plan_->visible.y;
  bool first = false;
  bool last = false;
  {
    const std::lock_guard lock(mutex_);
    if (groups_[group].published >= pass) return false;
    groups_[group].published = pass;
    first = finished_.empty();
    finished_.push_back(std::move(tile));
    last = pass == Pass::final_pixels && ++final_groups_ == groups_.size();
  }
  if (first) notify();
  return last;
}

Reached TileCollector::reached() const {
  const std::lock_guard lock(mutex_);
  Pass least = Pass::final_pixels;
  std::int64_t final_pixels = 0;
  for (const GroupState& group : groups_) {
    least = std::min(least, group.published);
    final_pixels += group.final_pixels;
  }
  Reached reached;
  const auto pixels = static_cast<std::int64_t>(plan_->visible.width) * plan_->visible.height;
  reached.final_share = static_cast<double>(final_pixels) / static_cast<double>(pixels);
  switch (least) {
    case Pass::nothing:
      break;
    case Pass::blocks:
      reached.pass = Reached::Pass::blocks;
      break;
    case Pass::quarters:
      reached.pass = Reached::Pass::quarters;
      break;
    case Pass::centres:
      reached.pass = Reached::Pass::centres;
      break;
    case Pass::final_pixels:
      reached.pass = Reached::Pass::final_pixels;
      break;
    default:
      reached.pass = Reached::Pass::level;
      reached.level = static_cast<int>(least) - static_cast<int>(Pass::first_level);
  }
  return reached;
}

void TileCollector::notify() const {
  if (on_tiles_) on_tiles_();
}

std::vector<FinishedTile> TileCollector::take_finished() {
  const std::lock_guard lock(mutex_);
  return std::exchange(finished_, {});
}

RenderStatistics TileCollector::statistics() const {
  const std::lock_guard lock(mutex_);
  RenderStatistics statistics = totals_;
  for (const GroupState& group : groups_) statistics.unresolved_area += group.unresolved_area;
  return statistics;
}

}  // namespace asos
