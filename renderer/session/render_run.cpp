#include "renderer/session/render_run.h"

#include "renderer/samples/sample_block.h"
#include "renderer/shading/shade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <span>
#include <utility>

namespace asos {
namespace {

constexpr std::chrono::milliseconds pace_step{100};
constexpr std::chrono::seconds pace_window{3};
constexpr std::chrono::milliseconds pace_enough{250};

double seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

// Of the calling thread's processor: what others do meanwhile does not count.
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

RenderRun::RenderRun(Snapshot snapshot, const std::function<void()>& on_tiles)
    : snapshot_(std::move(snapshot)),
      view_(snapshot_.camera, snapshot_.settings.width, snapshot_.settings.height,
            radius_around_origin(snapshot_.scene->world.bounds)),
      plan_(snapshot_.settings),
      on_tiles_(on_tiles),
      groups_(plan_.groups.size()) {}

void RenderRun::work(const std::stop_token& stop) {
  // No barrier stands between the passes: a worker that runs out of one goes on to the next, and
  // `publish` drops what a slower one brings too late.
  if (snapshot_.progressive) {
    work_coarse(stop);
    work_centres(stop);
  }
  work_final(stop);
}

FinishedTile RenderRun::tile_of(const BlockGroup& group) const {
  FinishedTile tile;
  tile.rect = intersection(group.rect, plan_.visible);
  const std::size_t pixels =
      static_cast<std::size_t>(tile.rect.width) * static_cast<std::size_t>(tile.rect.height);
  tile.radiance.resize(pixels, glm::vec3(0.0f));
  tile.split_level.resize(pixels, 0);
  tile.cause.resize(pixels, SplitCause::none);
  tile.coarse = true;
  return tile;
}

void RenderRun::copy_into(FinishedTile& tile, const FinishedTile& block) const {
  const PixelRect shared = intersection(tile.rect, block.rect);
  for (int y = shared.y; y < shared.y + shared.height; ++y) {
    const auto index = [&](const PixelRect& r) {
      return static_cast<std::ptrdiff_t>(y - r.y) * r.width + (shared.x - r.x);
    };
    std::copy_n(block.radiance.begin() + index(block.rect), shared.width,
                tile.radiance.begin() + index(tile.rect));
    std::copy_n(block.split_level.begin() + index(block.rect), shared.width,
                tile.split_level.begin() + index(tile.rect));
    std::copy_n(block.cause.begin() + index(block.rect), shared.width,
                tile.cause.begin() + index(tile.rect));
    if (tile.rays.empty()) continue;
    std::copy_n(block.rays.begin() + index(block.rect), shared.width,
                tile.rays.begin() + index(tile.rect));
    std::copy_n(block.seconds.begin() + index(block.rect), shared.width,
                tile.seconds.begin() + index(tile.rect));
  }
}

void RenderRun::publish(std::size_t group, Pass pass, FinishedTile&& tile) {
  tile.rect.x -= plan_.visible.x;
  tile.rect.y -= plan_.visible.y;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    if (groups_[group].published >= pass) return;
    groups_[group].published = pass;
    first = finished_.empty();
    finished_.push_back(std::move(tile));
  }
  if (first && on_tiles_) on_tiles_();
}

void RenderRun::work_coarse(const std::stop_token& stop) {
  const RenderScene& scene = *snapshot_.scene;
  const Shader shader = shader_of(scene, snapshot_.settings, view_);
  constexpr std::size_t blocks_in_group = (group_size / block_size) * (group_size / block_size);
  std::array<Ray, blocks_in_group> rays;
  std::array<Hit, blocks_in_group> hits;
  std::vector<glm::dvec3> sums;
  GridPlaces places(1, false);
  SampledLights lights(scene.rays, places);
  RenderStatistics uncounted;
  while (!stop.stop_requested()) {
    const std::size_t index = next_coarse_++;
    if (index >= plan_.groups.size()) return;
    const BlockGroup& group = plan_.groups[index];

    // One packet of rays through the middles of the group's blocks.
    for (std::size_t i = 0; i < group.block_count; ++i) {
      const PixelRect& r = plan_.blocks[group.first_block + i].rect;
      rays[i] = view_.ray(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
    }
    scene.rays.closest(std::span(rays).first(group.block_count),
                       std::span(hits).first(group.block_count), seen_faces(snapshot_.settings));
    FinishedTile tile = tile_of(group);
    sums.assign(group.block_count, glm::dvec3(0.0));
    for (std::size_t i = 0; i < group.block_count; ++i) {
      if (stop.stop_requested()) return;
      places.start_pixel(plan_.blocks[group.first_block + i].rect.x,
                         plan_.blocks[group.first_block + i].rect.y);
      lights.set_target(i);
      sums[i] = shader.radiance(rays[i], hits[i], float{block_size}, lights, uncounted);
    }
    lights.trace(sums);
    for (std::size_t i = 0; i < group.block_count; ++i) {
      glm::vec3 radiance(sums[i]);
      if (!std::isfinite(radiance.x + radiance.y + radiance.z)) radiance = glm::vec3(0.0f);
      FinishedTile block;
      block.rect = plan_.blocks[group.first_block + i].rect;
      const auto pixels = static_cast<std::size_t>(block.rect.width * block.rect.height);
      block.radiance.assign(pixels, radiance);
      block.split_level.assign(pixels, 0);
      block.cause.assign(pixels, SplitCause::none);
      copy_into(tile, block);
    }
    publish(index, coarse, std::move(tile));
  }
}

void RenderRun::work_centres(const std::stop_token& stop) {
  // A pixel's centre is what the regular grid of one sample takes.
  RenderSettings settings = snapshot_.settings;
  settings.method = Method::uniform;
  settings.sampling.spp = 1;
  while (!stop.stop_requested()) {
    const std::size_t index = next_centres_++;
    if (index >= plan_.groups.size()) return;
    const BlockGroup& group = plan_.groups[index];
    FinishedTile tile = tile_of(group);
    for (std::size_t i = 0; i < group.block_count; ++i) {
      if (stop.stop_requested()) return;
      const PixelRect& rect = plan_.blocks[group.first_block + i].rect;
      copy_into(tile, render_block(*snapshot_.scene, view_, settings, rect).tile);
    }
    publish(index, centres, std::move(tile));
  }
}

void RenderRun::work_final(const std::stop_token& stop) {
  {
    const std::lock_guard lock(mutex_);
    if (pace_.empty()) pace_.push_back({Clock::now(), 0});
  }
  while (wait_while_paused(stop)) {
    const std::size_t index = next_final_++;
    if (index >= plan_.blocks.size()) return;
    const double start = thread_seconds();
    BlockResult result =
        render_block(*snapshot_.scene, view_, snapshot_.settings, plan_.blocks[index].rect, stop);
    if (stop.stop_requested()) return;
    const std::size_t pixels = result.tile.radiance.size();
    const double each =
        (thread_seconds() - start) / static_cast<double>(std::max<std::size_t>(pixels, 1));
    result.tile.seconds.assign(pixels, static_cast<float>(each));
    finish_block(index, std::move(result));
  }
}

bool RenderRun::wait_while_paused(const std::stop_token& stop) {
  if (paused_) {
    std::unique_lock lock(mutex_);
    resumed_.wait(lock, stop, [this] { return !paused_; });
  }
  return !stop.stop_requested();
}

void RenderRun::pause() {
  const std::lock_guard lock(mutex_);
  if (paused_) return;
  paused_ = true;
  paused_since_ = Clock::now();
}

void RenderRun::resume() {
  {
    const std::lock_guard lock(mutex_);
    if (!paused_) return;
    // The clock and the pace go on from where they stood.
    const Clock::duration rest = Clock::now() - paused_since_;
    rested_ += rest;
    for (Pace& pace : pace_) pace.time += rest;
    paused_ = false;
  }
  resumed_.notify_all();
}

void RenderRun::finish_block(std::size_t index, BlockResult&& result) {
  const std::size_t group_index = plan_.blocks[index].group;
  const BlockGroup& group = plan_.groups[group_index];
  std::vector<BlockResult> whole;
  {
    const std::lock_guard lock(mutex_);
    // Integers add up in any order; the one sum that does not waits for its group.
    RenderStatistics counts = result.statistics;
    counts.unresolved_area = 0.0;
    totals_ += counts;
    GroupState& state = groups_[group_index];
    state.blocks.resize(group.block_count);
    state.blocks[index - group.first_block] = std::move(result);
    ++finished_blocks_;

    // Keep the pace of the last seconds.
    const Clock::time_point now = Clock::now();
    if (now - pace_.back().time >= pace_step) {
      pace_.push_back({now, finished_blocks_});
      while (pace_.size() > 2 && now - pace_[1].time > pace_window) pace_.pop_front();
    }
    if (++state.finished_blocks < group.block_count) return;
    whole = std::move(state.blocks);
    for (const BlockResult& block : whole) {
      state.unresolved_area += block.statistics.unresolved_area;
    }
  }

  FinishedTile tile = tile_of(group);
  tile.coarse = false;
  tile.rays.resize(tile.radiance.size());
  tile.seconds.resize(tile.radiance.size());
  for (const BlockResult& block : whole) copy_into(tile, block.tile);
  publish(group_index, final_pixels, std::move(tile));

  bool last = false;
  {
    const std::lock_guard lock(mutex_);
    // Groups that others still assemble are not published yet, and theirs will be the last.
    last = !complete_ && finished_blocks_ == plan_.blocks.size() &&
           std::all_of(groups_.begin(), groups_.end(),
                       [](const GroupState& g) { return g.published == final_pixels; });
    if (last) {
      complete_ = true;
      end_ = Clock::now();
    }
  }
  if (last && on_tiles_) on_tiles_();
}

std::vector<FinishedTile> RenderRun::take_finished() {
  const std::lock_guard lock(mutex_);
  return std::exchange(finished_, {});
}

double RenderRun::seconds_left(Clock::time_point now) const {
  if (complete_) return 0.0;
  if (pace_.empty() || closed_) return -1.0;
  const double passed = seconds(now - pace_.front().time);
  const auto done = static_cast<double>(finished_blocks_ - pace_.front().blocks);
  if (passed < seconds(pace_enough) || done <= 0.0) return -1.0;
  return static_cast<double>(plan_.blocks.size() - finished_blocks_) * passed / done;
}

Progress RenderRun::progress() const {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = complete_ || closed_ ? end_
                                : paused_            ? paused_since_
                                                     : Clock::now();
  Progress progress;
  progress.finished = complete_;
  progress.paused = paused_ && !complete_ && !closed_;
  progress.running = !complete_ && !closed_ && !paused_;
  progress.fraction = complete_
                          ? 1.0
                          : static_cast<double>(finished_blocks_) /
                                static_cast<double>(std::max<std::size_t>(plan_.blocks.size(), 1));
  progress.seconds = std::max(0.0, seconds(now - start_ - rested_));
  progress.seconds_left = seconds_left(now);
  return progress;
}

RenderStatistics RenderRun::statistics() const {
  const std::lock_guard lock(mutex_);
  RenderStatistics statistics = totals_;
  for (const GroupState& group : groups_) statistics.unresolved_area += group.unresolved_area;
  return statistics;
}

void RenderRun::close() {
  const std::lock_guard lock(mutex_);
  if (!complete_ && !closed_) end_ = paused_ ? paused_since_ : Clock::now();
  closed_ = true;
}

}  // namespace asos
