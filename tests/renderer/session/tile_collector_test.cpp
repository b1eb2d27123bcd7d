#include "renderer/session/tile_collector.h"

#include "tests/support/make_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace asos::tile_collector_test {
namespace {

// Two adjacent groups of 16 blocks each, without the picture's left column and top row.
RenderSettings two_groups() {
  RenderSettings settings = test::make_settings(64, 32);
  settings.crop = {1, 1, 63, 31};
  return settings;
}

/// A block whose pixels encode their place in the picture.
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

TEST(TileCollector, PublishesWhatIsVisibleOfABlock) {
  const WorkPlan plan(two_groups());
  ASSERT_EQ(plan.groups.size(), 2u);
  ASSERT_EQ(plan.blocks.size(), 32u);
  int calls = 0;
  TileCollector collector(plan, [&] { ++calls; });
  for (std::size_t b = 16; b-- > 0;)
    EXPECT_FALSE(collector.finish_block(b, block_at(plan.blocks[b].rect)));
  EXPECT_EQ(calls, 1) << "the others wait for the first";
  const std::vector<FinishedTile> tiles = collector.take_finished();
  ASSERT_EQ(tiles.size(), 16u);
  for (std::size_t b = 0; b < 16; ++b) {
    const FinishedTile& tile = tiles[15 - b];
    EXPECT_FALSE(tile.coarse);
    const PixelRect seen = intersection(plan.blocks[b].rect, plan.visible);
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
    EXPECT_EQ(collector.take_finished().size(), 32u);
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
  EXPECT_EQ(publish(pass_of_samples(1)), 1u);
  EXPECT_EQ(publish(Pass::quarters), 0u);
  EXPECT_EQ(publish(pass_of_samples(1)), 0u);
  EXPECT_EQ(publish(pass_of_samples(2)), 1u);
  for (std::size_t i = 16; i < 32; ++i)
    EXPECT_FALSE(collector.finish_block(i, block_at(plan.blocks[i].rect)));
  EXPECT_EQ(collector.take_finished().size(), 16u);
  EXPECT_EQ(publish(pass_of_samples(4)), 0u);
}

// A block that is final, or was started, is kept: samples replace only the others of its group.
TEST(TileCollector, KeepsWhatIsFinalOfAGroup) {
  const WorkPlan plan(two_groups());
  TileCollector collector(plan, {});
  for (const std::size_t group : {0, 1})
    collector.publish_coarse(group, pass_of_samples(4), collector.blank_tile(plan.groups[group]));
  EXPECT_FALSE(collector.finish_block(5, block_at(plan.blocks[5].rect)));
  collector.publish_started(6, block_at(plan.blocks[6].rect).tile);
  EXPECT_EQ(collector.take_finished().size(), 4u);
  for (const std::size_t group : {0, 1})
    collector.publish_coarse(group, pass_of_samples(8), collector.blank_tile(plan.groups[group]));
  const std::vector<FinishedTile> tiles = collector.take_finished();
  ASSERT_EQ(tiles.size(), 15u) << "the other blocks of the first group, and the second group";
  for (const FinishedTile& tile : tiles) {
    for (const std::size_t i : {5, 6}) {
      PixelRect own = intersection(plan.blocks[i].rect, plan.visible);
      own.x -= plan.visible.x;
      own.y -= plan.visible.y;
      EXPECT_TRUE(intersection(tile.rect, own).empty());
    }
  }
  EXPECT_EQ(collector.reached().pass, Reached::Pass::samples);
  EXPECT_EQ(collector.reached().samples, 8);
  const PixelRect block = intersection(plan.blocks[5].rect, plan.visible);
  EXPECT_EQ(collector.reached().final_share, block.width * block.height / (63.0 * 31.0));
}

}  // namespace
}  // namespace asos::tile_collector_test
