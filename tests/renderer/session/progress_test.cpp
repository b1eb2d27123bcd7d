// The fraction of the work that a render has done, and the time that it expects.

#include "renderer/session/run_clock.h"
#include "renderer/session/step_queue.h"
#include "renderer/session/tuning.h"
#include "tests/renderer/session/fence_picture.h"
#include "tests/renderer/session/recorded_costs.h"
#include "tests/support/make_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace asos::test::progress_test {
namespace {

using namespace fence_picture;

TEST(RunClock, ReportsWorkDoneOverAllWork) {
  RunClock clock;
  clock.begin_forecast();
  EXPECT_EQ(clock.progress().fraction, 0.0);
  clock.count(1.0, 3.0);
  EXPECT_DOUBLE_EQ(clock.progress().fraction, 0.25);
  clock.count(1.0, std::nullopt);
  EXPECT_DOUBLE_EQ(clock.progress().fraction, 0.5) << "as expected before";
  clock.count(0.0, 100.0);
  EXPECT_DOUBLE_EQ(clock.progress().fraction, 0.5) << "it never decreases";
  clock.complete();
  EXPECT_EQ(clock.progress().fraction, 1.0);
  EXPECT_EQ(clock.progress().seconds_left, 0.0);
}

/// The fraction after the first rounds of the fence.
double fraction_after(std::size_t rounds, const Snapshot& snapshot) {
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock;
  clock.begin_forecast();
  for (std::size_t round = 0; round < rounds; ++round)
    EXPECT_FALSE(samples.work(render, round, tiles, clock, {}));
  return clock.progress().fraction;
}

// One sample of each pixel has been taken, and the others take as long.
TEST(SampleRounds, ExpectTheirFurtherSamplesAtThePaceSoFar) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 64;
  EXPECT_NEAR(fraction_after(1, snapshot), 1.0 / 64.0, 1e-9);
  EXPECT_GT(fraction_after(6, snapshot), 0.3) << "half of the samples";
  EXPECT_LT(fraction_after(6, snapshot), 0.7);
}

// A direct render takes all samples of a group at once.
TEST(SampleRounds, ExpectTheOtherGroupsAtTheMeanPace) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 4;
  const PlannedRender render(snapshot);
  RunClock clock;
  clock.begin_forecast();
  std::vector<double> fractions;
  TileCollector tiles(render.plan, [&] {
    fractions.push_back(clock.progress().fraction);
    (void)tiles.take_finished();
  });
  SampleRounds samples(render);
  EXPECT_TRUE(samples.work(render, 2, tiles, clock, {}));
  ASSERT_EQ(fractions.size(), render.plan.groups.size());
  EXPECT_NEAR(fractions.front(), 1.0 / static_cast<double>(fractions.size()), 1e-9);
  EXPECT_NEAR(fractions.back(), 1.0, 1e-9);
}

// A worker may finish an early round of a group after others took it further.
TEST(SampleRounds, ExpectTheSameAfterALateRound) {
  Snapshot snapshot = fence(1, Method::sobol);
  snapshot.settings.sampling.spp = 64;
  const PlannedRender render(snapshot);
  TileCollector tiles(render.plan, {});
  SampleRounds samples(render);
  RunClock clock;
  clock.begin_forecast();
  EXPECT_FALSE(samples.work(render, 2, tiles, clock, {}));
  EXPECT_NEAR(clock.progress().fraction, 4.0 / 64.0, 1e-9);
  EXPECT_FALSE(samples.work(render, 0, tiles, clock, {}));
  EXPECT_LT(clock.progress().fraction, 0.5) << "60 of 64 samples are left";
}

TEST(SampleRounds, GuessTheTimeOfTheBlocksThatFollow) {
  EXPECT_NEAR(fraction_after(1, fence(1)),
              1.0 / (tuning::samples_before_steps + tuning::blocks_over_sample), 1e-9);
}

// A direct render has blocks in spread order. The worst factor between the expected time and the
// true one, from a tenth of the work on; times below a tenth of all count as a tenth.
TEST(StepQueue, ForecastsADirectRenderFromATenthOn) {
  const RenderSettings settings = make_settings(320, 180);
  const WorkPlan plan(settings);
  for (const RecordedCosts& recorded : recorded_costs) {
    const std::vector<double> costs = seconds_of(recorded.at_max_3);
    ASSERT_EQ(costs.size(), plan.blocks.size());
    const double all = std::accumulate(costs.begin(), costs.end(), 0.0);
    StepQueue queue(plan, settings.asos.eps);
    EXPECT_FALSE(queue.seconds_left()) << "nothing is measured";
    double done = 0.0, worst = 1.0;
    while (const std::optional<Step> step = queue.take(true)) {
      queue.done(*step, costs[step->block]);
      done += costs[step->block];
      if (done < 0.1 * all) continue;
      const double expected = std::max(queue.seconds_left().value(), 0.1 * all);
      const double left = std::max(all - done, 0.1 * all);
      worst = std::max({worst, expected / left, left / expected});
    }
    // A picture of 1280x720 has sixteen times the blocks, and factors of 1.1 to 1.3.
    EXPECT_LT(worst, 1.6) << recorded.scene;
    EXPECT_NEAR(queue.seconds_left().value(), 0.0, 1e-4);
  }
}

TEST(WorkPlan, SpreadOrdersHoldEachBlockOnce) {
  for (const int width : {8, 33, 320}) {
    const RenderSettings settings = make_settings(width, 40);
    const WorkPlan plan(settings);
    const auto expect_all = [](std::vector<std::size_t> order, std::size_t count) {
      std::sort(order.begin(), order.end());
      std::vector<std::size_t> all(count);
      std::iota(all.begin(), all.end(), std::size_t{0});
      EXPECT_EQ(order, all);
    };
    expect_all(plan.spread_blocks(), plan.blocks.size());
    expect_all(plan.spread_groups(), plan.groups.size());
  }
  // The first tenth of a thousand leaves no gap larger than twice the even spacing.
  std::vector<std::size_t> first = spread_order(1000);
  first.resize(100);
  std::sort(first.begin(), first.end());
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_LE(first[i] - first[i - 1], 20u) << i;
}

}  // namespace
}  // namespace asos::test::progress_test
