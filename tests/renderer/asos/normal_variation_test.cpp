#include "renderer/asos/normal_variation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace asos::normal_variation_test {
namespace {

constexpr int side = 8;
constexpr std::uint32_t background = 0xffffffffu;

/// Normals that turn about y by `angle(x)` at column x.
template <typename Angle>
std::vector<glm::vec3> turned(Angle angle) {
  std::vector<glm::vec3> normals;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double a = angle(x);
      normals.emplace_back(static_cast<float>(std::sin(a)), 0.0f, static_cast<float>(std::cos(a)));
    }
  }
  return normals;
}

const std::vector<std::uint32_t> one_surface(side* side, 7);

// A cylinder's normals have a constant second difference: 2 - 2 cos a for a step of angle a.
TEST(NormalVariation, MatchesClosedFormOnACylinder) {
  const double step = 0.2;
  NormalVariation normals;
  normals.find(side, turned([&](int x) { return step * x; }), one_surface, background);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      EXPECT_NEAR(normals.error(x, y), (2.0 - 2.0 * std::cos(step)) / 24.0, 1e-7) << x << ' ' << y;
}

// The actual error of the midpoint rule for the mean of a cosine over pixels with oscillating
// normals.
TEST(NormalVariation, BoundTheErrorOfTheMidpointRule) {
  const double amplitude = 0.3, frequency = 0.9;
  const auto angle = [&](double x) { return amplitude * std::sin(frequency * x); };
  NormalVariation normals;
  normals.find(side, turned(angle), one_surface, background);
  for (int x = 1; x + 1 < side; ++x) {
    // Light along the surface is the most sensitive direction.
    double mean = 0.0;
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) mean += std::sin(angle(x - 0.5 + (i + 0.5) / steps)) / steps;
    const double error = std::abs(mean - std::sin(angle(x)));
    EXPECT_GT(1.1 * normals.error(x, 3), error) << x;
    EXPECT_LT(normals.error(x, 3), 2.0 * error + 0.002) << x;
  }
}

TEST(NormalVariation, IsZeroBetweenSurfacesAndInTheBackground) {
  std::vector<std::uint32_t> surfaces = one_surface;
  for (int y = 0; y < side; ++y) {
    for (int x = 4; x < side; ++x)
      surfaces[static_cast<std::size_t>(y * side + x)] = y < 4 ? 8 : background;
  }
  // A crease between two flat surfaces.
  NormalVariation normals;
  normals.find(side, turned([](int x) { return x < 4 ? 0.0 : 1.0; }), surfaces, background);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) EXPECT_EQ(normals.error(x, y), 0.0f) << x << ' ' << y;
}

// On a cylinder, linear extrapolation of the normal is exact up to second order.
TEST(NormalVariation, MeasuresDeviationFromALinearTurn) {
  const double step = 0.02, bend = 1.01 * step * step;
  NormalVariation normals;
  normals.find(side, turned([&](int x) { return step * x; }), one_surface, background);
  for (int x = 0; x < side; ++x) {
    const auto along = [&](double turn) {
      const double a = step * x;
      return glm::vec3(turn * std::cos(a), 0.0, -turn * std::sin(a));
    };
    EXPECT_NEAR(normals.strays(x, 3, along(step), glm::vec3(0)), 0.0, bend) << x;
    EXPECT_NEAR(normals.strays(x, 3, along(3.0 * step), glm::vec3(0)), 2.0 * step, bend) << x;
    EXPECT_NEAR(normals.strays(x, 3, along(step), along(0.3)), 0.3, bend) << x;
  }
  EXPECT_EQ(normals.strays(-1, 3, glm::vec3(1), glm::vec3(1)), 0.0f);
  std::vector<std::uint32_t> surfaces(side * side);
  for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i] = static_cast<std::uint32_t>(i);
  normals.find(side, turned([&](int x) { return step * x; }), surfaces, background);
  EXPECT_EQ(normals.strays(3, 3, glm::vec3(1), glm::vec3(1)), 0.0f) << "other surfaces";
}

TEST(NormalVariation, IsZeroOutsideAndInTinyBlocks) {
  NormalVariation normals;
  normals.find(side, turned([](int x) { return 0.3 * x * x; }), one_surface, background);
  EXPECT_GT(normals.error(3, 3), 0.0f);
  EXPECT_EQ(normals.error(-1, 3), 0.0f);
  EXPECT_EQ(normals.error(3, side), 0.0f);
  const std::vector<glm::vec3> four(4, glm::vec3(0, 0, 1));
  const std::vector<std::uint32_t> same(4, 1);
  normals.find(2, four, same, background);
  EXPECT_EQ(normals.error(0, 0), 0.0f);
}

}  // namespace
}  // namespace asos::normal_variation_test
