#include "renderer/session/tile_collector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace asos::tile_collector_test {
namespace {

// Two groups beside each other, of 16 blocks each, without the picture's left column and top row.
RenderSettings two_groups() {
  RenderSettings settings;
  settings.width = 64;
  settings.height = 32;
  settings.crop = {1, 1, 63, 31};
  return settings;
}

/// A block whose pixels tell their place in the picture.
BlockResult block_at(const PixelRect& rect) {
  BlockResult result;
  result.tile.rect = rect;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      result.tile.radiance.emplace_back(x, y, 0);
      result.tile.split_level.push_back(static_cast<std::uint8_t>(x));
      result.tile.cause.push_back(SplitCause::crease);
      result.tile.rays.push_back(static_cast<float>(y));
      result.tile.seconds.push_back(2.0f);
    }
  }
  result.statistics.eye_rays = 3;
  result.statistics.unresolved_area = 0.1 * rect.x;
  return result;
}

TEST(TileCollector, PublishesAGroupOnceAllItsBlocksAreThere) {
  const WorkPlan plan(two_groups());
  ASSERT_EQ(plan.groups.size(), 2u);
  ASSERT_EQ(plan.blocks.size(), 32u);
  int calls = 0;
  TileCollector collector(plan, [&] { ++calls; });
  for (std::size_t i = 16; i-- > 0;) {
    EXPECT_TRUE(collector.take_finished().empty());
    EXPECT_FALSE(collector.finish_block(i, block_at(plan.blocks[i].rect)));
  }
  EXPECT_EQ(calls, 1);
  const std::vector<FinishedTile> tiles = collector.take_finished();
  ASSERT_EQ(tiles.size(), 1u);
  const FinishedTile& tile = tiles[0];
  EXPECT_FALSE(tile.coarse);
  const PixelRect seen = intersection(plan.groups[0].rect, plan.visible);
  EXPECT_EQ(tile.rect, (PixelRect{seen.x - 1, seen.y - 1, seen.width, seen.height}));
  std::size_t i = 0;
  for (int y = seen.y; y < seen.y + seen.height; ++y) {
    for (int x = seen.x; x < seen.x + seen.width; ++x, ++i) {
      ASSERT_EQ(tile.radiance[i], glm::vec3(x, y, 0));
      ASSERT_EQ(tile.split_level[i], x);
      ASSERT_EQ(tile.cause[i], SplitCause::crease);
      ASSERT_EQ(tile.rays[i], static_cast<float>(y));
      ASSERT_EQ(tile.seconds[i], 2.0f);
    }
  }
}

TEST(TileCollector, TellsTheLastBlockAndSumsInOneOrder) {
  const WorkPlan plan(two_groups());
  std::vector<double> areas;
  for (const bool forwards : {true, false}) {
    TileCollector collector(plan, {});
    for (std::size_t n = 0; n < plan.blocks.size(); ++n) {
      const std::size_t i = forwards ? n : plan.blocks.size() - 1 - n;
      EXPECT_EQ(collector.finish_block(i, block_at(plan.blocks[i].rect)),
                n + 1 == plan.blocks.size());
    }
    EXPECT_EQ(collector.take_finished().size(), 2u);
    EXPECT_EQ(collector.statistics().eye_rays, 3u * 32u);
    areas.push_back(collector.statistics().unresolved_area);
  }
  EXPECT_EQ(areas[0], areas[1]);
}

TEST(TileCollector, DropsPassesThatCameTooLate) {
  const WorkPlan plan(two_groups());
  TileCollector collector(plan, {});
  const auto publish = [&](Pass pass) {
    collector.publish_coarse(1, pass, collector.blank_tile(plan.groups[1]));
    return collector.take_finished().size();
  };
  EXPECT_EQ(publish(Pass::centres), 1u);
  EXPECT_EQ(publish(Pass::quarters), 0u);
  EXPECT_EQ(publish(Pass::centres), 0u);
  for (std::size_t i = 16; i < 32; ++i)
    EXPECT_FALSE(collector.finish_block(i, block_at(plan.blocks[i].rect)));
  EXPECT_EQ(collector.take_finished().size(), 1u);
  EXPECT_EQ(publish(Pass::centres), 0u);
}

// A block that is final stays so in the passes that follow, and when the render is stopped.
TEST(TileCollector, KeepsWhatIsFinalOfAGroup) {
  const WorkPlan plan(two_groups());
  TileCollector collector(plan, {});
  EXPECT_FALSE(collector.finish_block(5, block_at(plan.blocks[5].rect)));
  for (const std::size_t group : {0, 1})
    collector.publish_coarse(group, pass_of_level(1), collector.blank_tile(plan.groups[group]));
  const PixelRect block = intersection(plan.blocks[5].rect, plan.visible);
  const std::vector<FinishedTile> tiles = collector.take_finished();
  ASSERT_EQ(tiles.size(), 2u);
  const FinishedTile& tile = tiles[0];
  EXPECT_TRUE(tile.coarse);
  const auto at = [&](int x, int y) {
    return tile.radiance[static_cast<std::size_t>((y - 1 - tile.rect.y) * tile.rect.width + x - 1 -
                                                  tile.rect.x)];
  };
  EXPECT_EQ(at(block.x, block.y), glm::vec3(block.x, block.y, 0));
  EXPECT_EQ(std::count(tile.radiance.begin(), tile.radiance.end(), glm::vec3(0.0f)),
            static_cast<std::ptrdiff_t>(tile.radiance.size()) - block.width * block.height);
  EXPECT_EQ(collector.reached().pass, Reached::Pass::level);
  EXPECT_EQ(collector.reached().level, 1);
  EXPECT_EQ(collector.reached().final_share, block.width * block.height / (63.0 * 31.0));

  collector.publish_unfinished();
  const std::vector<FinishedTile> rest = collector.take_finished();
  ASSERT_EQ(rest.size(), 1u);
  EXPECT_FALSE(rest[0].coarse);
  EXPECT_EQ(rest[0].rect, (PixelRect{block.x - 1, block.y - 1, block.width, block.height}));
  EXPECT_EQ(rest[0].radiance[0], glm::vec3(block.x, block.y, 0));
  EXPECT_EQ(rest[0].rays.size(), rest[0].radiance.size());
}

}  // namespace
}  // namespace asos::tile_collector_test
