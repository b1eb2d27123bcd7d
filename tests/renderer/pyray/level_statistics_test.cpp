#include "renderer/pyray/level_statistics.h"

#include "renderer/geometry/ray.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace asos::test {
namespace {

using Objects = std::vector<std::uint32_t>;

TEST(LevelStatistics, CountsInAndOutForEachObject) {
  LevelStatistics tally;
  tally.start(3);
  tally.add_cell(Objects{5, 9}, 9, false);
  tally.add_cell(Objects{9}, Hit::none, true);
  tally.add_cell(Objects{2}, 2, true);
  tally.add_cell(Objects{2}, 9, true);
  tally.add_cell(Objects{2}, 2, true);
  EXPECT_EQ(tally.marginal, 5u);
  ASSERT_EQ(tally.objects.size(), 3u);
  const std::array<ObjectStatistics, 3> expected{ObjectStatistics{2, 2, 1, true},
                                                 ObjectStatistics{5, 0, 1, false},
                                                 ObjectStatistics{9, 1, 1, false}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(tally.objects[i].object, expected[i].object);
    EXPECT_EQ(tally.objects[i].in, expected[i].in);
    EXPECT_EQ(tally.objects[i].out, expected[i].out);
    EXPECT_EQ(tally.objects[i].one_edge, expected[i].one_edge);
  }
  EXPECT_EQ(tally.unresolved_area(), 5.0 / 64.0);
  // Object 2: L is 2, but at most half of each cell can change.
  EXPECT_EQ(tally.objects[0].change(3), 1.0 / 64.0);
  EXPECT_EQ(tally.objects[1].change(3), 1.0 / 64.0);
  EXPECT_EQ(tally.largest_change(), 1.0 / 64.0);
}

TEST(LevelStatistics, StartingALevelForgetsTheLast) {
  LevelStatistics tally;
  tally.start(1);
  tally.add_cell(Objects{1}, 1, false);
  tally.start(2);
  EXPECT_EQ(tally.level, 2);
  EXPECT_EQ(tally.marginal, 0u);
  EXPECT_TRUE(tally.objects.empty());
  EXPECT_EQ(tally.unresolved_area(), 0.0);
  EXPECT_EQ(tally.largest_change(), 0.0);
}

TEST(LevelStatistics, OfClustersAllCellsCanChange) {
  LevelStatistics tally;
  tally.start(1);
  tally.add_cell(Objects{ObjectStatistics::clusters}, 4, false);
  tally.add_cell(Objects{ObjectStatistics::clusters}, Hit::none, false);
  EXPECT_EQ(tally.objects[0].larger(), 2u);
  EXPECT_EQ(tally.largest_change(), 0.5);
}

}  // namespace
}  // namespace asos::test
