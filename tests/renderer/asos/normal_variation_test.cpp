#include "renderer/asos/normal_variation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace asos::normal_variation_test {
namespace {

constexpr int side = 8;

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

// On a cylinder, linear extrapolation of the normal is exact up to second order.
TEST(NormalVariation, MeasuresDeviationFromALinearTurn) {
  const double step = 0.02, bend = 1.01 * step * step;
  NormalVariation normals;
  normals.find(side, turned([&](int x) { return step * x; }), one_surface);
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
  normals.find(side, turned([&](int x) { return step * x; }), surfaces);
  EXPECT_EQ(normals.strays(3, 3, glm::vec3(1), glm::vec3(1)), 0.0f) << "other surfaces";
}

}  // namespace
}  // namespace asos::normal_variation_test
