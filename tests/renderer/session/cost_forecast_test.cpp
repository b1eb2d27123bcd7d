#include "renderer/session/cost_forecast.h"

#include "renderer/session/work_plan.h"
#include "tests/renderer/session/recorded_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asos::test {
namespace {

WorkPlan plan_of_recorded() {
  RenderSettings settings;
  settings.width = 320;
  settings.height = 180;
  return WorkPlan(settings);
}

double sum_of(const std::vector<double>& costs) {
  return std::accumulate(costs.begin(), costs.end(), 0.0);
}

/// The worst factors, at least 1, of estimates from a tenth of the work on: of the total time, and
/// of the remaining time. Remaining times below a tenth of the total count as a tenth.
struct Worst {
  double of_all = 1.0;
  double of_rest = 1.0;

  void look(const CostForecast& forecast, double all) {
    const double done = forecast.seconds_done();
    if (done < 0.1 * all) return;
    const double told = forecast.seconds_left().value_or(0.0);
    const auto factor = [](double x, double y) { return std::max(x / y, y / x); };
    of_all = std::max(of_all, factor(done + told, all));
    const double least = 0.1 * all;
    of_rest = std::max(of_rest, factor(std::max(told, least), std::max(all - done, least)));
  }
};

TEST(CostForecast, TellsARenderWithoutPassesFromATenthOn) {
  const WorkPlan plan = plan_of_recorded();
  for (const RecordedCosts& recorded : recorded_costs) {
    const std::vector<double> costs = seconds_of(recorded.at_max_3);
    ASSERT_EQ(costs.size(), plan.blocks.size());
    CostForecast forecast(costs.size());
    Worst worst;
    for (const std::size_t block : plan.spread_blocks()) {
      forecast.add(0, block, costs[block]);
      worst.look(forecast, sum_of(costs));
    }
    EXPECT_LT(worst.of_all, 1.5) << recorded.scene;
    // A picture of 1280x720 has sixteen times the blocks, and factors of 1.1 to 1.3.
    EXPECT_LT(worst.of_rest, 1.6) << recorded.scene;
    EXPECT_NEAR(*forecast.seconds_left(), 0.0, 1e-4);
  }
}

// A few blocks are rendered in both passes first. The prior is wrong by a factor of two.
TEST(CostForecast, TellsARenderInPassesFromATenthOn) {
  const WorkPlan plan = plan_of_recorded();
  for (const RecordedCosts& recorded : recorded_costs) {
    const std::vector<double> low = seconds_of(recorded.at_max_1);
    const std::vector<double> high = seconds_of(recorded.at_max_3);
    const double all = sum_of(low) + sum_of(high);
    CostForecast forecast(low.size(), {2.0 * sum_of(high) / sum_of(low)});
    Worst worst;
    // A picture of 1280x720 has as many groups as this one has blocks.
    const std::vector<std::size_t> order = plan.spread_blocks();
    const std::size_t tried = 48;
    for (std::size_t i = 0; i < tried; ++i) {
      forecast.add(0, order[i], low[order[i]]);
      forecast.add(1, order[i], high[order[i]]);
    }
    for (const std::size_t pass : {0, 1}) {
      for (std::size_t i = tried; i < order.size(); ++i) {
        forecast.add(pass, order[i], pass == 1 ? high[order[i]] : low[order[i]]);
        worst.look(forecast, all);
      }
    }
    EXPECT_LT(worst.of_all, 1.5) << recorded.scene;
    EXPECT_LT(worst.of_rest, 1.5) << recorded.scene;
    EXPECT_NEAR(*forecast.seconds_left(), 0.0, 1e-4);
  }
}

// Blocks that end in a pass cost nothing in the next one, and must not lower the forecast of the
// others.
TEST(CostForecast, IgnoresBlocksThatEndedInThePassBefore) {
  CostForecast forecast(8, {1.0});
  for (std::size_t i = 0; i < 4; ++i) {
    forecast.add(0, i, 1.0);
    forecast.add(1, i, i == 0 ? 3.0 : 0.0);
  }
  for (std::size_t i = 4; i < 6; ++i) forecast.add(0, i, 1.0);
  // One block took three times its first cost; the prior counts as four blocks with their first
  // cost.
  const double ratio = (3.0 + 4.0) / (1.0 + 4.0);
  // Two blocks wait for the second pass, and two more for both; half of all continue.
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 2.0 + 2.0 * ratio + 2.0 * 0.5 * ratio);
}

TEST(CostForecast, KnowsNothingBeforeABlockIsDone) {
  CostForecast forecast(10);
  EXPECT_FALSE(forecast.seconds_left());
  forecast.add(0, 3, 2.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 18.0);
}

// Once a block of each guessed pass was measured, the forecast no longer rests on the guess.
TEST(CostForecast, KnowsWhetherItGuesses) {
  CostForecast forecast(4, {5.0, 0.7});
  forecast.guess(1);
  forecast.guess(2);
  forecast.add(0, 0, 1.0);
  EXPECT_TRUE(forecast.guesses());
  forecast.add(1, 0, 3.0);
  EXPECT_TRUE(forecast.guesses());
  forecast.add(2, 0, 0.0);
  EXPECT_FALSE(forecast.guesses()) << "the block ended in the pass before";
  CostForecast known(4, {5.0});
  known.add(0, 0, 1.0);
  EXPECT_FALSE(known.guesses());
}

TEST(CostForecast, TakesThePassBeforeForAGuide) {
  CostForecast forecast(4, {5.0});
  for (std::size_t i = 0; i < 4; ++i) forecast.add(0, i, 1.0 + static_cast<double>(i));
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 50.0) << "from the prior alone";
  // A block with a ratio of three: the result is about halfway between the two ratios.
  forecast.add(1, 3, 12.0);
  const double ratio = (12.0 + 5.0 * 10.0) / (4.0 + 10.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 6.0 * ratio);
  // A block that returns is finished work, not another block.
  forecast.add(1, 3, 12.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 6.0 * ratio);
  EXPECT_DOUBLE_EQ(forecast.seconds_done(), 34.0);
}

TEST(CostForecast, PassesThatAreLeftOutCostNothing) {
  CostForecast forecast(2, {2.0, 3.0});
  for (const std::size_t block : {0, 1}) forecast.add(0, block, 1.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 4.0 + 12.0);
  forecast.leave_out(1);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 12.0) << "the last pass costs as much as before";
}

TEST(CostForecast, BlocksThatCostNothingHarmNothing) {
  CostForecast forecast(3, {1.0, 1.0});
  for (const std::size_t pass : {0, 1, 2}) forecast.add(pass, 0, 0.0);
  EXPECT_EQ(*forecast.seconds_left(), 0.0);
}

TEST(WorkPlan, SpreadOrdersHoldEachBlockOnce) {
  for (const int width : {8, 33, 320}) {
    RenderSettings settings;
    settings.width = width;
    settings.height = 40;
    const WorkPlan plan(settings);
    for (std::vector<std::size_t> order :
         {plan.spread_blocks(), plan.blocks_of(plan.spread_groups())}) {
      std::sort(order.begin(), order.end());
      std::vector<std::size_t> all(plan.blocks.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      EXPECT_EQ(order, all);
    }
  }
  // The first tenth of a thousand leaves no gap larger than twice the even spacing.
  std::vector<std::size_t> first = spread_order(1000);
  first.resize(100);
  std::sort(first.begin(), first.end());
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_LE(first[i] - first[i - 1], 20u) << i;
}

}  // namespace
}  // namespace asos::test
