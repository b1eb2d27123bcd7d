#include "renderer/lights/polygon_rows.h"

#include <gtest/gtest.h>

#include <array>

namespace asos::polygon_rows_test {
namespace {

using Outlines = std::vector<std::vector<glm::dvec2>>;

/// A square of side 4 with a hole of side 2 in its centre, and a tooth on top.
const Outlines frame{{{0, 0}, {4, 0}, {4, 4}, {2, 6}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};

TEST(PolygonRows, HasTheArea) {
  EXPECT_NEAR(PolygonRows::of(frame).area, 16.0 - 4.0 + 4.0, 1e-14);
  EXPECT_EQ(PolygonRows::of(Outlines{{{0, 0}, {1, 1}, {2, 2}}}).area, 0.0);
  EXPECT_EQ(PolygonRows::of(Outlines{}).area, 0.0);
}

TEST(PolygonRows, SpreadsPointsByArea) {
  const PolygonRows rows = PolygonRows::of(frame);
  constexpr int count = 400;
  int in_hole = 0;
  int in_tooth = 0;
  int left_of_hole = 0;
  int in_tip = 0;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const glm::dvec2 p = rows.point((i + 0.5) / count, (k + 0.5) / count);
      if (p.x > 1 && p.x < 3 && p.y > 1 && p.y < 3) ++in_hole;
      if (p.x < 1 && p.y > 1 && p.y < 3) ++left_of_hole;
      if (p.y > 4) ++in_tooth;
      if (p.y > 5) ++in_tip;
    }
  }
  EXPECT_EQ(in_hole, 0);
  EXPECT_EQ(in_tooth, count * count / 4);      // 4 of 16
  EXPECT_EQ(left_of_hole, count * count / 8);  // 2 of 16
  EXPECT_EQ(in_tip, count * count / 16);  // the upper half of a triangle has a quarter of its area
}

TEST(PolygonRows, ReachesTheCornersOfTheSquare) {
  const PolygonRows rows = PolygonRows::of(frame);
  EXPECT_EQ(rows.point(0, 0), glm::dvec2(0, 0));
  EXPECT_EQ(rows.point(1, 0), glm::dvec2(4, 0));
  EXPECT_NEAR(glm::length(rows.point(0.3, 1) - glm::dvec2(2, 6)), 0.0, 1e-7);
}

}  // namespace
}  // namespace asos::polygon_rows_test
