#include "renderer/geometry/clip_segment.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

using glm::dvec2;

TEST(ClipSegment, KeepsPartBetweenOppositeSides) {
  // From (-1, 0.5) to (3, 1.5), the unit square is entered at a quarter and left at a half.
  const SegmentPart<double> part =
      clip_segment<double>({-1.0, 0.5}, {4.0, 1.0}, dvec2(0.0), dvec2(1.0));
  EXPECT_DOUBLE_EQ(part.t0, 0.25);
  EXPECT_DOUBLE_EQ(part.t1, 0.5);
}

TEST(ClipSegment, KeepsSegmentInside) {
  const SegmentPart<float> part =
      clip_segment<float>({3.0f, 4.0f}, {-1.0f, 0.5f}, glm::vec2(1.0f), glm::vec2(5.0f));
  EXPECT_EQ(part.t0, 0.0f);
  EXPECT_EQ(part.t1, 1.0f);
}

TEST(ClipSegment, IsEmptyBesideRectangle) {
  // Diagonal past a corner, parallel to a side, and ending before the rectangle.
  EXPECT_TRUE(clip_segment<double>({-1.0, 0.5}, {1.5, 1.5}, dvec2(0.0), dvec2(1.0)).empty());
  EXPECT_TRUE(clip_segment<double>({-1.0, 1.5}, {3.0, 0.0}, dvec2(0.0), dvec2(1.0)).empty());
  EXPECT_TRUE(clip_segment<double>({-1.0, 0.5}, {0.5, 0.0}, dvec2(0.0), dvec2(1.0)).empty());
}

TEST(ClipSegment, KeepsParallelSegmentOnBorderButNoPoint) {
  const SegmentPart<double> along =
      clip_segment<double>({-1.0, 1.0}, {4.0, 0.0}, dvec2(0.0), dvec2(1.0));
  EXPECT_DOUBLE_EQ(along.t0, 0.25);
  EXPECT_DOUBLE_EQ(along.t1, 0.5);
  // The segment touches only the corner (0, 0).
  EXPECT_TRUE(clip_segment<double>({-1.0, 1.0}, {2.0, -2.0}, dvec2(0.0), dvec2(1.0)).empty());
}

}  // namespace
}  // namespace asos
