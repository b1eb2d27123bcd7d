// The rounds of samples of all groups, and single pixels that continue them.

#include "renderer/session/sample_rounds.h"

#include "renderer/comparison/method.h"
#include "tests/renderer/session/fence_picture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>
#include <utility>
#include <vector>

namespace asos::test::sample_rounds_test {
namespace {

using namespace fence_picture;

TEST(SampleRounds, DoubleUntilThePictureHasItsSamples) {
  Snapshot snapshot = fence(1, Method::uniform);
  snapshot.settings.sampling.spp = 10;
  const SampleRounds own{PlannedRender(snapshot)};
  EXPECT_TRUE(own.make_the_picture());
  EXPECT_EQ(own.rounds(), (std::vector{1, 2, 4, 8, 16}));
  snapshot.settings.sampling.spp = 9;
  EXPECT_EQ(SampleRounds{PlannedRender(snapshot)}.rounds(), (std::vector{1, 2, 4, 8, 9}));
  const SampleRounds first{PlannedRender(fence(1))};
  EXPECT_FALSE(first.make_the_picture());
  EXPECT_EQ(first.rounds(), (std::vector{1, 2, 4}));
}

// The sums of a group are freed once it is final.
TEST(SampleRounds, FreeTheirSumsOnceNobodyNeedsThem) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 4;
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock;
  clock.begin_forecast();
  for (const std::size_t round : {0, 1})
    EXPECT_FALSE(samples.work(render, round, tiles, clock, {}));
  EXPECT_GT(samples.bytes(), sizeof(SampleSums::Sum) * width * height);
  EXPECT_TRUE(samples.work(render, 2, tiles, clock, {}));
  EXPECT_EQ(samples.bytes(), 0u);
}

// Single pixels that continue have the samples of a block in which all do.
TEST(SampleRounds, ContinueSinglePixels) {
  Sampled of;
  const WorkPlan& plan = of.render.plan;
  std::vector<PlannedPixel> some;
  for (std::uint32_t b = 0; b < plan.blocks.size(); b += 7) {
    const PixelRect& block = plan.blocks[b].rect;
    some.push_back({b, block.x + 3, block.y + 1});
    if (b % 2 == 0) some.push_back({b, block.x, block.y});
  }
  Film film(width, height);
  for (const FinishedTile& tile : of.tiles.take_finished()) film.put(tile);
  Film expected = film;
  for (const BlockGroup& group : plan.groups) {
    RenderSettings settings = of.render.snapshot.settings;
    settings.method = Method::sobol;
    const BlockJob job = of.render.job(settings, group.rect, {});
    const auto places = row_of(Method::sobol).places(settings);
    PixelSamples pixels(group.rect);
    for (const int end : {1, 2, 4, 16}) pixels.advance(job, *places, end, end);
    for (const PlannedPixel& p : some) {
      if (plan.groups[plan.blocks[p.block].group].rect != group.rect) continue;
      const std::size_t at = expected.index(p.x, p.y);
      EXPECT_NE(expected.radiance[at], glm::vec3(0.0f));
      expected.radiance[at] = glm::vec3(pixels.sum(pixels.index(p.x, p.y)).mean());
    }
  }
  const auto sampled = of.samples.continue_pixels(of.render, some, of.tiles, {});
  ASSERT_EQ(sampled.size(), some.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    const std::size_t at = expected.index(some[i].x, some[i].y);
    const glm::vec3 off =
        glm::clamp(expected.radiance[at], 0.0f, 1.0f) - glm::clamp(film.radiance[at], 0.0f, 1.0f);
    EXPECT_EQ(sampled[i].taken, 16);
    EXPECT_NEAR(sampled[i].moved, glm::dot(off, off), 1e-5f);
  }
  const std::vector<FinishedTile> tiles = of.tiles.take_finished();
  EXPECT_EQ(tiles.size(), (plan.blocks.size() + 6) / 7);
  for (const FinishedTile& tile : tiles) film.put(tile);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    // Packets of other rays may change the last bits of a hit.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(film.radiance[i][c], expected.radiance[i][c], 1e-4f);
    changed += film.radiance[i] != expected.radiance[i];
  }
  EXPECT_LT(changed, some.size() / 2);
}

// A worker that enters after the others have passed some rounds walks through them again, and
// leaves the order of the later ones alone.
TEST(SampleRounds, ALateWorkerLeavesTheOrderOfALaterRoundAlone) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 16;
  const PlannedRender render(snapshot);
  const auto groups = static_cast<int>(render.plan.groups.size());
  // Relaxed, so that only the rounds' own locks order the threads: the thread sanitizer reports
  // an order that changes while it is read.
  constexpr auto relaxed = std::memory_order_relaxed;
  std::atomic<bool> enters = false, entered = false;
  std::map<std::pair<int, int>, int> seen;
  int shown = 0;
  TileCollector tiles(render.plan, [&] {
    for (const FinishedTile& tile : tiles.take_finished()) ++seen[{tile.rect.x, tile.rect.y}];
    if (++shown != 3 * groups + groups / 3) return;
    enters.store(true, relaxed);
    while (!entered.load(relaxed)) std::this_thread::yield();
  });
  SampleRounds samples(render);
  RunClock clock;
  clock.begin_forecast();
  std::jthread late([&] {
    while (!enters.load(relaxed)) std::this_thread::yield();
    EXPECT_TRUE(samples.put_what_moves_first(1, {}));
    entered.store(true, relaxed);
  });
  for (std::size_t round = 0; round < samples.rounds().size(); ++round) {
    ASSERT_TRUE(samples.put_what_moves_first(round, {}));
    EXPECT_EQ(samples.work(render, round, tiles, clock, {}), round == 4);
  }
  EXPECT_TRUE(entered);
  EXPECT_EQ(seen.size(), render.plan.groups.size());
  for (const auto& [place, count] : seen) EXPECT_EQ(count, 5) << "rounds of 1, 2, 4, 8 and 16";
  EXPECT_EQ(tiles.statistics().eye_rays, 16u * width * height);
}

}  // namespace
}  // namespace asos::test::sample_rounds_test
