#pragma once

#include "renderer/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asos::test {

/// Equal up to a few roundings of a double, relative to the larger vector's length.
inline void expect_close(glm::dvec3 a, glm::dvec3 b) {
  const double size = std::max({glm::length(a), glm::length(b), 1e-300});
  EXPECT_LT(glm::length(a - b), 1e-12 * size)
      << "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y << ", " << b.z
      << ")";
}

/// Equal in every field that the type uses.
inline void expect_equal(const Light& a, const Light& b) {
  SCOPED_TRACE(a.name);
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.type, b.type);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.intensity, b.intensity);
  EXPECT_EQ(a.range, b.range);
  EXPECT_EQ(a.casts_shadows, b.casts_shadows);
  EXPECT_EQ(a.two_sided, b.two_sided);
  EXPECT_NEAR(a.radius, b.radius, 1e-14 * a.radius);
  EXPECT_EQ(a.angular_diameter_rad, b.angular_diameter_rad);
  if (a.type != Light::Type::polygon) {
    EXPECT_EQ(a.position, b.position);
  }
  if (a.type != Light::Type::point && a.type != Light::Type::linear) {
    expect_close(a.direction, b.direction);
  }
  if (a.type == Light::Type::spot) {
    EXPECT_EQ(a.inner_cone_rad, b.inner_cone_rad);
    EXPECT_EQ(a.outer_cone_rad, b.outer_cone_rad);
  }
  expect_close(a.half_u, b.half_u);
  expect_close(a.half_v, b.half_v);
  ASSERT_EQ(a.outlines.size(), b.outlines.size());
  for (std::size_t o = 0; o < a.outlines.size(); ++o) {
    ASSERT_EQ(a.outlines[o].size(), b.outlines[o].size());
    for (std::size_t i = 0; i < a.outlines[o].size(); ++i) {
      expect_close(a.outlines[o][i], b.outlines[o][i]);
    }
  }
}

}  // namespace asos::test
