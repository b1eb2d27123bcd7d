// The order of steps after the rounds, and their outcome.

#include "renderer/session/step_queue.h"

#include "renderer/session/render_steps.h"
#include "renderer/session/tuning.h"
#include "tests/renderer/session/fence_picture.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace asos::test::step_queue_test {
namespace {

using namespace fence_picture;

/// Does all steps of a queue, each in the time that `seconds` says.
template <typename Seconds>
std::vector<Step> all_steps(StepQueue& queue, const Seconds& seconds) {
  std::vector<Step> steps;
  while (!queue.finished()) {
    std::optional<Step> step = queue.take(true);
    if (!step) ADD_FAILURE() << "no step, and not finished";
    if (!step) break;
    std::vector<StepQueue::Sampled> sampled;
    if (step->kind == Step::Kind::samples) {
      for (std::size_t i = 0; i < step->pixels.size(); ++i) sampled.push_back({16, 0.001f});
    }
    queue.done(*step, seconds(*step), sampled);
    steps.push_back(*std::move(step));
  }
  return steps;
}

TEST(StepQueue, RendersEachBlockOnceInSpreadOrderWithoutSamples) {
  const PlannedRender render(fence(1));
  StepQueue queue(render.plan, 1.0 / 256.0);
  const std::vector<Step> steps = all_steps(queue, [](const Step&) { return 0.5; });
  std::vector<std::size_t> blocks;
  for (const Step& step : steps) {
    EXPECT_EQ(step.kind, Step::Kind::start);
    blocks.push_back(step.block);
  }
  EXPECT_EQ(blocks, render.plan.spread_blocks());
}

TEST(StepQueue, RendersThePreferredPartFirst) {
  Sampled of;
  const WorkPlan& plan = of.render.plan;
  const PixelRect part{100, 10, 20, 30};
  const auto touches = [&](std::size_t block) {
    return !intersection(plan.blocks[block].rect, part).empty();
  };
  StepQueue queue(plan, 1.0 / 256.0);
  queue.begin(of.samples);
  std::optional<Step> planned = queue.take(true);  // others are planned with it
  ASSERT_TRUE(planned);
  std::vector<StepQueue::Sampled> sampled(planned->pixels.size(), {16, 0.001f});
  queue.done(*planned, planned->seconds, sampled);
  queue.prefer(part);
  const std::vector<Step> steps = all_steps(queue, [](const Step& step) { return step.seconds; });
  std::vector<int> seen(plan.blocks.size(), 0);
  if (planned->kind == Step::Kind::start) ++seen[planned->block];
  bool others = false;
  for (const Step& step : steps) {
    if (step.kind == Step::Kind::start) ++seen[step.block];
    const bool preferred = step.kind == Step::Kind::start && touches(step.block);
    EXPECT_FALSE(preferred && others) << "block " << step.block << " came late";
    others |= !preferred;
  }
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
}

// Most of the error lies in few pixels: they come before anything else, and blocks of flat pixels
// come last.
TEST(StepQueue, LargestGainsComeFirst) {
  Sampled of;
  StepQueue queue(of.render.plan, 1.0 / 256.0);
  queue.begin(of.samples);
  double rounds = 0.0;
  for (std::size_t g = 0; g < of.render.plan.groups.size(); ++g) rounds += of.samples.seconds(g);
  const double of_block = 20.0 * rounds / static_cast<double>(of.render.plan.blocks.size());
  const std::vector<Step> steps = all_steps(queue, [&](const Step& step) {
    return step.kind == Step::Kind::samples ? step.seconds : of_block;
  });
  std::vector<double> seen(of.render.plan.blocks.size(), 0.0);
  std::set<std::pair<int, int>> sampled;
  double early = 0.0, all = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].kind == Step::Kind::start) ++seen[steps[i].block];
    for (const PlannedPixel& p : steps[i].pixels) {
      sampled.emplace(p.x, p.y);
      EXPECT_EQ(seen[p.block], 0.0) << "a pixel of a block that is rendered already";
    }
    if (std::isinf(steps[i].gain)) continue;  // measures its kind
    const double gain = steps[i].gain * steps[i].seconds;
    all += gain;
    if (i < steps.size() / 4) early += gain;
  }
  EXPECT_EQ(seen, std::vector<double>(seen.size(), 1.0));
  EXPECT_GT(sampled.size(), 100u);
  EXPECT_LT(sampled.size(), std::size_t{width} * height) << "flat pixels wait for their blocks";
  EXPECT_GT(early, 0.7 * all);
}

// Until blocks can be rendered, pixels take samples, and then none is left.
TEST(StepQueue, TakesSamplesWhileBlocksCannotBeRendered) {
  Sampled of;
  StepQueue queue(of.render.plan, 1.0 / 256.0);
  queue.begin(of.samples);
  std::size_t samples = 0;
  while (const std::optional<Step> step = queue.take(false)) {
    ASSERT_EQ(step->kind, Step::Kind::samples);
    std::vector<StepQueue::Sampled> sampled;
    for (std::size_t i = 0; i < step->pixels.size(); ++i)
      sampled.push_back({tuning::most_samples, 0.0f});
    samples += step->pixels.size();
    queue.done(*step, step->seconds, sampled);
  }
  EXPECT_GT(samples, 100u);
  EXPECT_FALSE(queue.finished());
  EXPECT_FALSE(queue.seconds_left().has_value()) << "no block was measured";
  const std::optional<Step> step = queue.take(true);
  ASSERT_TRUE(step.has_value());
  EXPECT_EQ(step->kind, Step::Kind::start);
}

// Unlit surfaces have their final colour from the first stage on.
TEST(RenderSteps, OfAnUnlitSurfaceComeInTwoStages) {
  World world = still_life().world;
  world.materials[world.parts.front().material].unlit = true;
  Snapshot snapshot{.scene = make_render_scene(std::move(world), still_life().lights),
                    .camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7),
                    .settings = {.width = 64, .height = 64, .asos = {.max_level = 2}}};
  const PlannedRender render(snapshot);
  ASSERT_TRUE(render.unlit);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RenderSteps steps(render, samples);
  RunClock clock;
  clock.begin_forecast();
  EXPECT_TRUE(steps.work(render, tiles, clock, {}));
  std::size_t started = 0, partly_unlit = 0;
  Film film(64, 64);
  for (const FinishedTile& tile : tiles.take_finished()) {
    film.put(tile);
    if (!tile.coarse) continue;
    ++started;
    partly_unlit += tile.unlit.empty() ? 0 : 1;
  }
  EXPECT_GT(started, 0u);
  EXPECT_GT(partly_unlit, 0u);
  const Film direct = render_to_end(snapshot).film;
  EXPECT_EQ(film.radiance, direct.radiance);
  EXPECT_TRUE(film.unlit == direct.unlit);
}

}  // namespace
}  // namespace asos::test::step_queue_test
