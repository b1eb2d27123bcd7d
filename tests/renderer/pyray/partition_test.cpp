#include "renderer/pyray/partition.h"

#include "tests/support/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace asos {
namespace {

Segment line(double u0, double v0, double u1, double v1) {
  Segment s;
  s.u0 = static_cast<float>(u0), s.v0 = static_cast<float>(v0);
  s.u1 = static_cast<float>(u1), s.v1 = static_cast<float>(v1);
  return s;
}

double total_area(std::span<const CellPart> parts) {
  double sum = 0.0;
  for (const CellPart& f : parts) sum += f.area;
  return sum;
}

// The part whose sample is nearest to (u, v).
const CellPart& part_near(std::span<const CellPart> parts, float u, float v) {
  return *std::min_element(parts.begin(), parts.end(), [&](const CellPart& a, const CellPart& b) {
    return std::hypot(a.u - u, a.v - v) < std::hypot(b.u - u, b.v - v);
  });
}

TEST(CellPartition, OneLineGivesTheExactAreasOfBothSides) {
  CellPartition partition;

  const Segment s = line(0.9, 0.1, 0.4, 0.6);
  const auto parts = partition.cut({0.5f, 0.25f, 0.25f}, std::span(&s, 1), 8);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(total_area(parts), 1.0, 1e-9);
  // u + v = 1 is the diagonal of this cell.
  EXPECT_NEAR(parts[0].area, 0.5, 1e-6);
}

TEST(CellPartition, TwoParallelLinesLeaveASliverOfExactWidth) {
  CellPartition partition;
  const Segment lines[2] = {line(-1, 0.5, 2, 0.5), line(-1, 0.501, 2, 0.501)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 3u);
  const CellPart& sliver = part_near(parts, 0.5f, 0.5005f);
  EXPECT_NEAR(sliver.area, 0.001, 1e-7);
  EXPECT_GT(sliver.v, 0.5f);
  EXPECT_LT(sliver.v, 0.501f);
}

TEST(CellPartition, ThreeEdgesAtOneCornerMakeThreeFaces) {
  CellPartition partition;
  const Segment lines[3] = {line(0.5, 0.5, 0.5, -1), line(0.5, 0.5, 2, 0.5), line(0.5, 0.5, -1, 2)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(total_area(parts), 1.0, 1e-9);
  EXPECT_NEAR(part_near(parts, 0.75f, 0.25f).area, 0.25, 1e-6);
  EXPECT_NEAR(part_near(parts, 0.2f, 0.3f).area, 0.375, 1e-6);
}

TEST(CellPartition, CrossingLinesMakeFourFaces) {
  CellPartition partition;
  const Segment lines[2] = {line(-1, 0.25, 2, 0.25), line(0.5, -1, 0.5, 2)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_NEAR(part_near(parts, 0.25f, 0.1f).area, 0.125, 1e-6);
  EXPECT_NEAR(part_near(parts, 0.75f, 0.6f).area, 0.375, 1e-6);
}

TEST(CellPartition, SubtractsIslandsFromTheirSurroundings) {
  CellPartition partition;
  const Segment lines[3] = {line(0.4, 0.4, 0.6, 0.4), line(0.6, 0.4, 0.5, 0.6),
                            line(0.5, 0.6, 0.4, 0.4)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 2u);
  const CellPart& island = parts[0].area < parts[1].area ? parts[0] : parts[1];
  const CellPart& sea = parts[0].area < parts[1].area ? parts[1] : parts[0];
  EXPECT_NEAR(island.area, 0.02, 1e-7);
  EXPECT_NEAR(sea.area, 0.98, 1e-7);
  // The sea's sample is not on the island.
  EXPECT_FALSE(sea.v > 0.4f && sea.v < 0.6f && std::abs(sea.u - 0.5f) < 0.5f * (0.6f - sea.v));
}

TEST(CellPartition, ABentChainIsOneBoundary) {
  CellPartition partition;
  // A zigzag from left to right around v = 0.5.
  std::vector<Segment> chain;
  const int n = 10;
  const auto height = [](int i) { return i % 2 ? 0.55 : 0.45; };
  for (int i = 0; i < n; ++i)
    chain.push_back(line(i / 10.0, height(i), (i + 1) / 10.0, height(i + 1)));
  const auto parts = partition.cut({0, 0, 1}, chain, 8);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].area, 0.5, 1e-6);
  for (const CellPart& f : parts) EXPECT_GT(std::abs(f.v - 0.5f), 0.051f);
}

// A mirrored corner and the outline of the leaf that reflects it are found separately, with a small
// gap.
TEST(CellPartition, ALineThatEndsALittleBeforeTheNextGoesOnToIt) {
  CellPartition partition;
  const Segment lines[2] = {line(0.5, -1, 0.5, 2), line(-1, 0.25, 0.49, 0.25)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(part_near(parts, 0.25f, 0.1f).area, 0.125, 1e-7);
  EXPECT_NEAR(part_near(parts, 0.25f, 0.6f).area, 0.375, 1e-7);
  EXPECT_NEAR(part_near(parts, 0.75f, 0.5f).area, 0.5, 1e-7);
}

TEST(CellPartition, TwoLinesThatEndBesideEachOtherMakeACorner) {
  CellPartition partition;
  // Neither line blocks the other, and the border is far.
  const Segment lines[2] = {line(-1, 0.5, 0.5, 0.5), line(0.505, 0.505, 0.505, 2)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(part_near(parts, 0.25f, 0.75f).area, 0.25, 0.005);
  EXPECT_NEAR(total_area(parts), 1.0, 1e-9);
}

TEST(CellPartition, ALineThatEndsFarFromAnyOtherBoundsNothing) {
  CellPartition partition;
  const Segment lines[2] = {line(0.5, -1, 0.5, 2), line(-1, 0.25, 0.4, 0.25)};
  EXPECT_EQ(partition.cut({0, 0, 1}, lines, 8).size(), 2u);
}

TEST(CellPartition, LinesAlongTheBorderBoundNothing) {
  CellPartition partition;
  const Segment lines[2] = {line(-1, 0, 2, 0), line(0.3, 0.3, 0.3 + 1e-9, 0.3)};
  const auto parts = partition.cut({0, 0, 1}, lines, 8);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_DOUBLE_EQ(parts[0].area, 1.0);
}

// An outline too small to cut along: its sample must not represent the cell.
TEST(CellPartition, PlacesSamplesOffSpecks) {
  CellPartition partition;
  for (const float size : {0.0f, 1e-7f, 1e-6f, 3e-6f, 1e-5f, 1e-3f}) {
    for (const glm::vec2 at : {glm::vec2(0.5f), glm::vec2(0.25f, 0.5f), glm::vec2(0.25f, 0.625f)}) {
      const Square cell{at.x - 0.25f, at.y - 0.25f, 0.5f};
      const glm::vec2 c[3] = {at + size * glm::vec2(-1, -1), at + size * glm::vec2(1, -1),
                              at + size * glm::vec2(0, 1)};
      std::vector<Segment> lines;
      for (int i = 0; i < 3; ++i)
        lines.push_back(line(c[i].x, c[i].y, c[(i + 1) % 3].x, c[(i + 1) % 3].y));
      for (const bool beside_a_line : {false, true}) {
        // The speck is at the centroid of the part that the line leaves, or of the cell.
        if (beside_a_line) lines.push_back(line(at.x + 0.25, -1, at.x + 0.25, 2));
        double speck = 0.0;
        const auto parts = partition.cut(cell, lines, 8);
        ASSERT_FALSE(parts.empty()) << size;
        EXPECT_NEAR(total_area(parts), 1.0, 1e-9);
        for (const CellPart& part : parts) {
          const float away = std::max(std::abs(part.u - at.x), std::abs(part.v - at.y));
          if (away <= size) speck += part.area;
          EXPECT_TRUE(away <= size || away > 1e-3f) << size;
        }
        EXPECT_NEAR(speck, 8.0 * size * size, 4e-6 * size + 1e-11) << size;
      }
    }
  }
}

TEST(CellPartition, RefusesMoreFacesThanAllowed) {
  CellPartition partition;
  const Segment lines[2] = {line(-1, 0.25, 2, 0.25), line(0.5, -1, 0.5, 2)};
  EXPECT_TRUE(partition.cut({0, 0, 1}, lines, 3).empty());
  const Segment bad = line(std::nan(""), 0, 1, 1);
  EXPECT_TRUE(partition.cut({0, 0, 1}, std::span(&bad, 1), 3).empty());
}

// Full lines split a convex polygon into convex polygons: an independent computation of the areas.
TEST(CellPartition, AgreesWithHalfPlaneClippingOnRandomLines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  CellPartition partition;
  for (int repetition = 0; repetition < 1000; ++repetition) {
    const int n = 1 + repetition % 4;
    std::vector<Segment> lines;
    std::vector<test::Polygon> polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (int i = 0; i < n; ++i) {
      const glm::dvec2 p(unit(random), unit(random));
      const double angle = unit(random) * 2.0 * std::numbers::pi;
      const glm::dvec2 d(std::cos(angle), std::sin(angle));
      lines.push_back(line(p.x - 3 * d.x, p.y - 3 * d.y, p.x + 3 * d.x, p.y + 3 * d.y));
      const glm::dvec2 a(lines.back().u0, lines.back().v0);
      const glm::dvec2 b(lines.back().u1, lines.back().v1);
      std::vector<test::Polygon> split;
      for (const test::Polygon& polygon : polygons) {
        for (const double sign : {1.0, -1.0}) {
          test::Polygon kept = test::clip(polygon, [&](glm::dvec2 q) {
            return sign * ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x));
          });
          if (kept.size() > 2) split.push_back(std::move(kept));
        }
      }
      polygons = split;
    }
    std::vector<double> expected;
    for (const test::Polygon& polygon : polygons) expected.push_back(test::area(polygon));
    std::vector<double> got;
    for (const CellPart& f : partition.cut({0, 0, 1}, lines, 64)) got.push_back(f.area);
    // Slivers narrower than the snapping distance may be merged into a neighbour.
    const auto tiny = [](double a) { return a < 2e-5; };
    std::erase_if(expected, tiny);
    std::erase_if(got, tiny);
    std::sort(expected.begin(), expected.end());
    std::sort(got.begin(), got.end());
    ASSERT_EQ(got.size(), expected.size()) << "repetition " << repetition;
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_NEAR(got[i], expected[i], 2e-5) << "repetition " << repetition;
  }
}

}  // namespace
}  // namespace asos
