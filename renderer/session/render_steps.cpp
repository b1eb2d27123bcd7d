#include "renderer/session/render_steps.h"

#include "renderer/comparison/method.h"
#include "renderer/prepared/exposure.h"
#include "renderer/session/thread_seconds.h"
#include "renderer/session/tuning.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

BlockJob job_of(const PlannedRender& render, std::size_t block, const std::stop_token& stop) {
  return render.job(render.snapshot.settings, render.plan.blocks[block].rect, stop);
}

void set_seconds(double seconds, FinishedTile& tile) {
  const std::size_t pixels = tile.radiance.size();
  const double each = seconds / static_cast<double>(std::max<std::size_t>(pixels, 1));
  tile.seconds.assign(pixels, static_cast<float>(each));
}

/// Returns the boundaries that the method uses: of the scene, and of its moments while the shutter
/// is open.
std::vector<const BoundaryFeatures*> boundaries_of(const PlannedRender& render) {
  const RenderScene& scene = *render.snapshot.scene;
  if (!needs_boundaries(render.snapshot.settings.method)) return {};
  std::vector<const BoundaryFeatures*> all{&scene.geometry->boundaries};
  if (scene.exposure)
    for (const auto& moment : scene.exposure->moments) all.push_back(&moment->geometry->boundaries);
  return all;
}

}  // namespace

RenderSteps::RenderSteps(const PlannedRender& render, SampleRounds& samples)
    : samples_(samples),
      most_bytes_(tuning::bytes_a_pixel * static_cast<std::size_t>(render.plan.visible.width) *
                  static_cast<std::size_t>(render.plan.visible.height)),
      started_(render.plan.blocks.size()),
      queue_(render.plan, render.snapshot.settings.asos.eps) {}

void RenderSteps::begin() {
  const std::lock_guard lock(mutex_);
  if (!queue_.begun()) queue_.begin(samples_);
}

void RenderSteps::prefer(const PixelRect& part) {
  const std::lock_guard lock(mutex_);
  queue_.prefer(part);
}

bool RenderSteps::work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                       const std::stop_token& stop) {
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    const std::optional<Step> step = next(render, clock, stop);
    if (!step) break;
    finished_picture |= perform(render, *step, tiles, clock, stop);
    changed_.notify_all();
  }
  return finished_picture;
}

bool RenderSteps::blocks_can_start(const PlannedRender& render) {
  for (const BoundaryFeatures* boundaries : boundaries_of(render))
    if (!boundaries->known_or_started()) return false;
  return true;
}

// Waits for the next step; none: no step is left, boundaries failed, or `stop` is requested.
std::optional<Step> RenderSteps::next(const PlannedRender& render, RunClock& clock,
                                      const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested() && !queue_.finished()) {
    const bool blocks = blocks_can_start(render);
    if (blocks || queue_.begun()) {
      if (std::optional<Step> step = queue_.take(blocks)) {
        ++running_;
        return step;
      }
    }
    if (running_ > 0) {
      const std::size_t done = done_;
      changed_.wait(lock, stop, [&] { return done_ != done; });
      continue;
    }
    // Pixels take no more samples, so only the boundaries can help.
    lock.unlock();
    for (const BoundaryFeatures* boundaries : boundaries_of(render)) {
      if (boundaries->wait(stop)) continue;
      if (boundaries->failed()) clock.fail();
      return std::nullopt;
    }
    lock.lock();
  }
  return std::nullopt;
}

bool RenderSteps::perform(const PlannedRender& render, const Step& step, TileCollector& tiles,
                          RunClock& clock, const std::stop_token& stop) {
  const double before = thread_seconds();
  bool finished_picture = false;
  std::vector<StepQueue::Sampled> sampled;
  switch (step.kind) {
    case Step::Kind::samples:
      sampled = samples_.continue_pixels(render, step.pixels, tiles, stop);
      break;
    case Step::Kind::start:
      finished_picture = start(render, step.block, tiles, stop);
      break;
    case Step::Kind::finish:
      finished_picture = finish(render, step.block, tiles, stop);
      break;
  }
  const double seconds = thread_seconds() - before;
  const std::lock_guard lock(mutex_);
  --running_;
  ++done_;
  if (stop.stop_requested()) return false;
  queue_.done(step, seconds, sampled);
  if (step.kind == Step::Kind::start && started_[step.block].rest)
    queue_.open(step.block, started_[step.block].rest->squared_error());
  clock.count(seconds, queue_.seconds_left());
  return finished_picture;
}

// Renders the method's first stage of a block, and publishes it. Returns true if that finished the
// picture.
bool RenderSteps::start(const PlannedRender& render, std::size_t block, TileCollector& tiles,
                        const std::stop_token& stop) {
  const RenderSettings& settings = render.snapshot.settings;
  const BlockJob job = job_of(render, block, stop);
  const auto first_stage = row_of(settings.method).start;
  const bool in_stages = render.snapshot.progressive && first_stage && !render.motion &&
                         !shows_coverage(settings) && bytes_ < most_bytes_;
  const double before = thread_seconds();
  StartedBlock done;
  if (in_stages) {
    done = first_stage(job);
  } else {
    done.result = render_block(job);
  }
  if (render.unlit) add_unlit(job, done.result);
  if (stop.stop_requested()) return false;
  fill_in(done.result);
  const double seconds = thread_seconds() - before;
  set_seconds(seconds, done.result.tile);
  if (!done.rest) return tiles.finish_block(block, std::move(done.result));
  bytes_ += done.rest->bytes() + done.result.tile.unlit.size() * sizeof(glm::vec4);
  started_[block] = {std::move(done.rest), done.result.tile.unlit, seconds};
  tiles.publish_started(block, std::move(done.result.tile));
  return false;
}

bool RenderSteps::finish(const PlannedRender& render, std::size_t block, TileCollector& tiles,
                         const std::stop_token& stop) {
  Started& started = started_[block];
  const double before = thread_seconds();
  BlockResult result = started.rest->finish(job_of(render, block, stop));
  started.rest.reset();
  renew_unlit(std::move(started.unlit), result);
  if (stop.stop_requested()) return false;
  fill_in(result);
  set_seconds(started.seconds + thread_seconds() - before, result.tile);
  return tiles.finish_block(block, std::move(result));
}

}  // namespace asos
