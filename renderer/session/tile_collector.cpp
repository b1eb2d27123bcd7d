#include "renderer/session/tile_collector.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

FinishedTile part_of(const FinishedTile& tile, const PixelRect& rect) {
  FinishedTile part;
  part.rect = rect;
  part.coarse = tile.coarse;
  const auto pixels = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  part.radiance.resize(pixels);
  part.split_level.resize(pixels);
  part.cause.resize(pixels);
  if (!tile.rays.empty()) part.rays.resize(pixels);
  if (!tile.seconds.empty()) part.seconds.resize(pixels);
  if (!tile.coverage.empty()) part.coverage.resize(pixels);
  if (!tile.outlook.empty()) part.outlook.resize(pixels);
  if (!tile.unlit.empty()) part.unlit.resize(pixels);
  for (const LayerPlane& plane : tile.layers) part.layers.emplace_back(plane.layer, pixels);
  copy_pixels(tile, part);
  return part;
}

}  // namespace

TileCollector::TileCollector(const WorkPlan& plan, std::function<void()> on_tiles)
    : plan_(&plan),
      on_tiles_(std::move(on_tiles)),
      groups_(plan.groups.size()),
      started_(plan.blocks.size(), false),
      unresolved_area_(plan.blocks.size(), 0.0) {}

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

// Cuts off the part of a tile that lies outside the crop.
FinishedTile TileCollector::visible_part(FinishedTile&& tile) const {
  const PixelRect seen = intersection(tile.rect, plan_->visible);
  return seen == tile.rect ? std::move(tile) : part_of(tile, seen);
}

// The caller holds the mutex.
void TileCollector::start(std::size_t block) {
  if (started_[block]) return;
  started_[block] = true;
  ++groups_[plan_->blocks[block].group].started_blocks;
}

// The caller holds the mutex.
void TileCollector::put(FinishedTile&& tile) {
  tile.rect.x -= plan_->visible.x;
  tile.rect.y -= plan_->visible.y;
  finished_.push_back(std::move(tile));
}

void TileCollector::publish_coarse(std::size_t group, Pass pass, FinishedTile&& tile) {
  FinishedTile seen = visible_part(std::move(tile));
  seen.coarse = true;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    GroupState& state = groups_[group];
    if (state.published >= pass) return;
    state.published = pass;
    const bool none = finished_.empty();
    if (state.started_blocks == 0) {
      put(std::move(seen));
    } else {
      const BlockGroup& all = plan_->groups[group];
      for (std::size_t block = all.first_block; block < all.first_block + all.block_count; ++block)
        if (!started_[block])
          put(part_of(seen, intersection(plan_->blocks[block].rect, seen.rect)));
    }
    first = none && !finished_.empty();
  }
  if (first) notify();
}

void TileCollector::publish_sampled(std::size_t block, FinishedTile&& tile) {
  publish_block(block, false, std::move(tile));
}

void TileCollector::publish_started(std::size_t block, FinishedTile&& tile) {
  publish_block(block, true, std::move(tile));
}

void TileCollector::publish_block(std::size_t block, bool starts, FinishedTile&& tile) {
  FinishedTile seen = visible_part(std::move(tile));
  seen.coarse = true;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    if (starts)
      start(block);
    else if (started_[block])
      return;
    first = finished_.empty();
    put(std::move(seen));
  }
  if (first) notify();
}

bool TileCollector::finish_block(std::size_t block, BlockResult&& result) {
  const std::size_t index = plan_->blocks[block].group;
  FinishedTile seen = visible_part(std::move(result.tile));
  seen.coarse = false;
  bool first = false, last = false;
  {
    const std::lock_guard lock(mutex_);
    // Kept per block: unlike integer counts, a floating-point sum depends on the order.
    unresolved_area_[block] = std::exchange(result.statistics.unresolved_area, 0.0);
    totals_ += result.statistics;
    GroupState& state = groups_[index];
    start(block);
    state.final_pixels += static_cast<std::int64_t>(seen.rect.width) * seen.rect.height;
    if (++state.finished_blocks == plan_->groups[index].block_count)
      state.published = Pass::final_pixels;
    last = ++final_blocks_ == plan_->blocks.size();
    first = finished_.empty();
    put(std::move(seen));
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
    case Pass::final_pixels:
      reached.pass = Reached::Pass::final_pixels;
      break;
    default:
      reached.pass = Reached::Pass::samples;
      reached.samples = 1 << (static_cast<int>(least) - static_cast<int>(Pass::first_samples));
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
  for (const double area : unresolved_area_) statistics.unresolved_area += area;
  return statistics;
}

}  // namespace asos
