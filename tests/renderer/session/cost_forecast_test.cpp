#include "renderer/session/cost_forecast.h"

#include "renderer/session/work_plan.h"
#include "tests/renderer/session/recorded_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

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

/// The worst factor, above 1, by which estimates of all the work were off from a tenth of it on,
/// and those of what was left; the last tenth counts as a tenth.
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
      forecast.add(CostForecast::final_pass, block, costs[block]);
      worst.look(forecast, sum_of(costs));
    }
    EXPECT_LT(worst.of_all, 1.5) << recorded.scene;
    // A picture of 1280x720 has sixteen times the blocks: there it was 1.1 to 1.3.
    EXPECT_LT(worst.of_rest, 1.6) << recorded.scene;
    EXPECT_NEAR(*forecast.seconds_left(), 0.0, 1e-4);
    EXPECT_NEAR(forecast.share_done(), 1.0, 1e-3);
  }
}

TEST(CostForecast, TellsARenderInPassesFromATenthOn) {
  const WorkPlan plan = plan_of_recorded();
  for (const RecordedCosts& recorded : recorded_costs) {
    const std::vector<double> low = seconds_of(recorded.at_max_1);
    const std::vector<double> high = seconds_of(recorded.at_max_3);
    const double all = sum_of(low) + sum_of(high);
    CostForecast forecast(low.size());
    Worst worst;
    // A picture of 1280x720 has as many groups as this one has blocks.
    const std::vector<std::size_t> order = plan.spread_blocks();
    const std::set<std::size_t> sample(order.begin(), order.begin() + 48);
    for (const std::size_t block : sample) {
      forecast.add(1, block, low[block]);
      forecast.add(CostForecast::final_pass, block, high[block]);
    }
    forecast.set_levels(std::array{1});
    for (const bool last : {false, true}) {
      for (const std::size_t block : order) {
        if (sample.contains(block)) continue;
        forecast.add(last ? CostForecast::final_pass : 1, block, last ? high[block] : low[block]);
        worst.look(forecast, all);
      }
    }
    EXPECT_LT(worst.of_all, 1.5) << recorded.scene;
    EXPECT_LT(worst.of_rest, 1.5) << recorded.scene;
  }
}

TEST(CostForecast, KnowsNothingBeforeABlockIsDone) {
  CostForecast forecast(10);
  EXPECT_FALSE(forecast.seconds_left());
  EXPECT_EQ(forecast.share_done(), 0.0);
  forecast.add(CostForecast::final_pass, 3, 2.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 18.0);
  EXPECT_DOUBLE_EQ(forecast.share_done(), 0.1);
}

TEST(CostForecast, TakesThePassBeforeForAGuide) {
  CostForecast forecast(4);
  forecast.set_levels(std::array{1});
  for (std::size_t i = 0; i < 4; ++i) forecast.add(1, i, 1.0 + static_cast<double>(i));
  EXPECT_FALSE(forecast.seconds_left()) << "nothing tells what the final pass costs";
  forecast.add(CostForecast::final_pass, 3, 12.0);  // three times what it was
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 18.0);
  // A block that comes again is work that is done, and not another block.
  forecast.add(CostForecast::final_pass, 3, 12.0);
  EXPECT_DOUBLE_EQ(*forecast.seconds_left(), 18.0);
  EXPECT_DOUBLE_EQ(forecast.seconds_done(), 34.0);
}

TEST(CostForecast, BlocksThatCostNothingHarmNothing) {
  CostForecast forecast(3);
  forecast.set_levels(std::array{0, 1});
  for (const std::size_t pass : {std::size_t{0}, std::size_t{1}, CostForecast::final_pass})
    forecast.add(pass, 0, 0.0);
  EXPECT_EQ(*forecast.seconds_left(), 0.0);
  EXPECT_EQ(forecast.share_done(), 0.0);
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
  // The first tenth of a thousand leaves no gap of more than twice its even share.
  std::vector<std::size_t> first = spread_order(1000);
  first.resize(100);
  std::sort(first.begin(), first.end());
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_LE(first[i] - first[i - 1], 20u) << i;
}

}  // namespace
}  // namespace asos::test
