#include "renderer/asos/footprint_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace asos {
namespace {

std::vector<BorderEdge> around(const std::vector<glm::vec2>& corners) {
  std::vector<BorderEdge> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return sides;
}

FootprintShape shape_of(const std::vector<BorderEdge>& sides, glm::vec2 at) {
  return footprint_shape({{0.0f, 0.0f, 1.0f}, sides, false}, at);
}

void expect_near(glm::vec2 got, glm::vec2 expected) {
  EXPECT_NEAR(got.x, expected.x, 1e-5f);
  EXPECT_NEAR(got.y, expected.y, 1e-5f);
}

TEST(FootprintShape, OfWholeSquaresIsTheSquare) {
  const FootprintShape shape = shape_of({}, {0.5f, 0.5f});
  EXPECT_EQ(shape.offset, glm::vec2(0.0f));
  EXPECT_EQ(shape.right, glm::vec2(1.0f, 0.0f));
  EXPECT_EQ(shape.down, glm::vec2(0.0f, 1.0f));
}

TEST(FootprintShape, MatchesAStrip) {
  // 0.64 wide and 0.25 high: the square of equal area has the side 0.4.
  for (const bool turned : {false, true}) {
    std::vector<glm::vec2> corners{{0.1f, 0.5f}, {0.74f, 0.5f}, {0.74f, 0.75f}, {0.1f, 0.75f}};
    if (turned) std::reverse(corners.begin(), corners.end());
    const FootprintShape shape = shape_of(around(corners), {0.5f, 0.6f});
    expect_near(shape.offset, glm::vec2(0.42f - 0.5f, 0.625f - 0.6f) / 0.4f);
    expect_near(shape.right, {1.6f, 0.0f});
    expect_near(shape.down, {0.0f, 0.625f});
  }
}

// The mean of a quadratic over the parallelogram equals that over the part.
TEST(FootprintShape, HasTheMomentsOfAnyPart) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<float> u(0.0f, 1.0f);
  for (int i = 0; i < 50; ++i) {
    const std::vector<glm::vec2> corners{{u(rng), u(rng)}, {u(rng), u(rng)}, {u(rng), u(rng)}};
    const glm::dvec2 a(corners[0]), b(corners[1]), c(corners[2]);
    const double area = 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    if (area < 0.02) continue;
    const glm::vec2 at(u(rng), u(rng));
    const FootprintShape shape = shape_of(around(corners), at);
    const double side = std::sqrt(area);
    const glm::dvec2 middle = glm::dvec2(at) + side * glm::dvec2(shape.offset);
    const glm::dvec2 e = side * glm::dvec2(shape.right), f = side * glm::dvec2(shape.down);
    // The triangle's mean is that of its corners; its second moments are the sum of the corners'
    // outer products about the mean, divided by 12.
    const glm::dvec2 mean = (a + b + c) / 3.0;
    const auto product = [&](int x, int y) {
      double sum = 0.0;
      for (const glm::dvec2& p : {a, b, c}) sum += (p[x] - mean[x]) * (p[y] - mean[y]);
      return sum / 12.0;
    };
    EXPECT_NEAR(middle.x, mean.x, 1e-5);
    EXPECT_NEAR(middle.y, mean.y, 1e-5);
    for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 1}})
      EXPECT_NEAR((e[x] * e[y] + f[x] * f[y]) / 12.0, product(x, y), 1e-5);
  }
}

TEST(FootprintShape, WithoutAreaIsTheSquare) {
  const FootprintShape shape =
      shape_of(around({{0.2f, 0.2f}, {0.8f, 0.8f}, {0.2f, 0.2f}}), {0.3f, 0.3f});
  EXPECT_EQ(shape.right, glm::vec2(1.0f, 0.0f));
  EXPECT_EQ(shape.down, glm::vec2(0.0f, 1.0f));
}

/// The second moments of a parallelogram about its centre.
glm::dvec3 spread_of(const FootprintShape& shape) {
  const glm::dvec2 e(shape.right), f(shape.down);
  return glm::dvec3(e.x * e.x + f.x * f.x, e.x * e.y + f.x * f.y, e.y * e.y + f.y * f.y) / 12.0;
}

// The parts together have the area, the centre and the second moments of the whole.
TEST(FootprintShape, PartsHaveTheMomentsOfTheWhole) {
  std::mt19937 rng(12);
  std::uniform_real_distribution<float> u(0.0f, 1.0f);
  for (int i = 0; i < 50; ++i) {
    // Triangles, and quadrilaterals that may be concave.
    std::vector<glm::vec2> corners{{u(rng), u(rng)}, {u(rng), u(rng)}, {u(rng), u(rng)}};
    if (i % 2 == 0) corners.push_back(0.4f * corners[0] + 0.3f * corners[1] + 0.3f * corners[2]);
    const std::vector<BorderEdge> sides = around(corners);
    const glm::vec2 at(u(rng), u(rng));
    const FootprintShape whole = shape_of(sides, at);
    if (whole.right == glm::vec2(1.0f, 0.0f)) continue;  // no area
    for (const int n : {1, 2, 3, 8}) {
      std::vector<WeightedShape> parts;
      add_footprint_shapes({{0.0f, 0.0f, 1.0f}, sides, false}, at, n, parts);
      ASSERT_FALSE(parts.empty());
      EXPECT_LE(parts.size(), static_cast<std::size_t>(n * n));
      double share = 0.0;
      glm::dvec2 middle(0.0);
      for (const WeightedShape& part : parts) {
        share += static_cast<double>(part.share);
        middle += static_cast<double>(part.share) * glm::dvec2(part.shape.offset);
      }
      glm::dvec3 spread(0.0);
      for (const WeightedShape& part : parts) {
        const glm::dvec2 off = glm::dvec2(part.shape.offset) - middle;
        spread += static_cast<double>(part.share) *
                  (spread_of(part.shape) + glm::dvec3(off.x * off.x, off.x * off.y, off.y * off.y));
      }
      // Tolerance for parts that are too small to be kept.
      const double size = static_cast<double>(glm::length(whole.right) + glm::length(whole.down));
      EXPECT_NEAR(share, 1.0, 1e-5);
      EXPECT_NEAR(glm::distance(middle, glm::dvec2(whole.offset)), 0.0, 0.02 * size)
          << i << ' ' << n;
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(spread[k], spread_of(whole)[k], 0.02 * size * size) << i << ' ' << n;
    }
  }
}

TEST(FootprintShape, OfASquareInFourAreItsQuarters) {
  const auto sides = around({{0.25f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.75f}, {0.25f, 0.75f}});
  std::vector<WeightedShape> parts;
  add_footprint_shapes({{0.0f, 0.0f, 1.0f}, sides, false}, {0.5f, 0.5f}, 2, parts);
  ASSERT_EQ(parts.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(parts[i].share, 0.25f);
    expect_near(parts[i].shape.offset, {i % 2 == 0 ? -0.25f : 0.25f, i < 2 ? -0.25f : 0.25f});
    expect_near(parts[i].shape.right, {0.5f, 0.0f});
    expect_near(parts[i].shape.down, {0.0f, 0.5f});
  }
}

}  // namespace
}  // namespace asos
