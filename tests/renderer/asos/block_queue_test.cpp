#include "renderer/asos/block_queue.h"

#include <gtest/gtest.h>

#include <array>

namespace asos::test::block_queue_test {
namespace {

TEST(BlockQueue, KeepsTheOrderOfContributions) {
  BlockQueue queue;
  EXPECT_TRUE(queue.empty());
  const PyrayLeaf first{3, 7, 0.5, {}}, second{1, 8, 0.25, {}};
  EXPECT_EQ(queue.add(first), 0u);
  EXPECT_EQ(queue.add(second), 1u);
  queue[1].radiance = glm::dvec3(2.0);
  queue[0].dropped = true;
  const std::span<const Contribution> taken = queue.take();
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(taken[0].leaf, &first);
  EXPECT_TRUE(taken[0].dropped);
  EXPECT_EQ(taken[1].leaf, &second);
  EXPECT_EQ(taken[1].radiance, glm::dvec3(2.0));
  EXPECT_FALSE(taken[1].dropped);
}

TEST(BlockQueue, IsEmptyOnceTaken) {
  BlockQueue queue;
  const PyrayLeaf first{0, 0, 1.0, {}}, second{5, 1, 1.0, {}};
  queue.add(first);
  EXPECT_EQ(queue.take().size(), 1u);
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.add(second), 0u) << "numbers restart at 0";
  EXPECT_EQ(queue[0].radiance, glm::dvec3(0.0)) << "taken samples are gone";
  EXPECT_EQ(queue.take().size(), 1u);
}

TEST(BlockQueue, SharesRaysOutByParts) {
  BlockQueue queue;
  const std::array leaves{PyrayLeaf{0, 0, 1.0, {}}, PyrayLeaf{1, 1, 1.0, {}},
                          PyrayLeaf{2, 2, 1.0, {}}};
  for (const PyrayLeaf& leaf : leaves) queue.add(leaf);
  queue.share_rays(100.0, std::array{1.0, 3.0, 0.0});
  EXPECT_EQ(queue[0].rays, 25.0);
  EXPECT_EQ(queue[1].rays, 75.0);
  EXPECT_EQ(queue[2].rays, 0.0);
  queue.share_rays(100.0, std::array{0.0, 0.0, 0.0});
  EXPECT_EQ(queue[1].rays, 75.0);
}

}  // namespace
}  // namespace asos::test::block_queue_test
