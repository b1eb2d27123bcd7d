#include "app/turntable.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

TEST(ParseFrames, TakesARangeOneOrAll) {
  const auto range = parse_frames("10-19/120");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first, 10);
  EXPECT_EQ(range->last, 19);
  EXPECT_EQ(range->count, 120);
  EXPECT_EQ(parse_frames("7/8")->first, 7);
  EXPECT_EQ(parse_frames("7/8")->last, 7);
  EXPECT_EQ(parse_frames("24")->first, 0);
  EXPECT_EQ(parse_frames("24")->last, 23);
  for (const char* wrong : {"", "0", "8/8", "5-3/8", "-1/8", "1-/8", "a", "1/2/3", "100001"})
    EXPECT_FALSE(parse_frames(wrong)) << wrong;
}

TEST(TurnedCamera, GoesAroundTheMiddleAndLooksAtItStill) {
  Camera camera;
  const glm::dvec3 middle(1, 2, 3);
  camera.world_from_camera[3] = glm::dvec4(middle + glm::dvec3(0, 1, 5), 1.0);
  EXPECT_EQ(turned_camera(camera, middle, 0, 12).world_from_camera, camera.world_from_camera);
  // A quarter turn, counter-clockwise from above: from +Z to +X.
  const Camera quarter = turned_camera(camera, middle, 3, 12);
  const glm::dvec3 at(quarter.world_from_camera[3]);
  EXPECT_NEAR(glm::length(at - (middle + glm::dvec3(5, 1, 0))), 0.0, 1e-14);
  EXPECT_NEAR(glm::length(glm::dvec3(quarter.world_from_camera[2]) - glm::dvec3(1, 0, 0)), 0.0,
              1e-14);
  EXPECT_NEAR(glm::length(glm::dvec3(quarter.world_from_camera[1]) - glm::dvec3(0, 1, 0)), 0.0,
              1e-14);
}

TEST(FramePath, NumbersSortAsFrames) {
  EXPECT_EQ(frame_path("a/turn.png", 7, 120), "a/turn-007.png");
  EXPECT_EQ(frame_path("turn.v2.exr", 99, 100), "turn.v2-99.exr");
  EXPECT_EQ(frame_path("turn.png", 0, 1), "turn-0.png");
}

}  // namespace
}  // namespace asos
