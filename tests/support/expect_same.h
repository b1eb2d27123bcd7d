#pragma once

#include "renderer/film/film.h"
#include "renderer/film/statistics.h"

#include <gtest/gtest.h>

namespace asos::test {

/// Expects equality, bit by bit.
inline void expect_same(const RenderStatistics& a, const RenderStatistics& b) {
  EXPECT_EQ(a.eye_rays, b.eye_rays);
  EXPECT_EQ(a.shadow_rays, b.shadow_rays);
  EXPECT_EQ(a.shadow_pyrays, b.shadow_pyrays);
  EXPECT_EQ(a.lights, b.lights);
  EXPECT_EQ(a.reflection_rays, b.reflection_rays);
  EXPECT_EQ(a.pyrays_by_level, b.pyrays_by_level);
  EXPECT_EQ(a.split_pixels, b.split_pixels);
  EXPECT_EQ(a.missed_splits, b.missed_splits);
  EXPECT_EQ(a.saturated_pixels, b.saturated_pixels);
  EXPECT_EQ(a.uneven_pixels, b.uneven_pixels);
  EXPECT_EQ(a.unresolved_area, b.unresolved_area);
  EXPECT_EQ(a.rejected_samples, b.rejected_samples);
  EXPECT_EQ(a.pixels_by_cause, b.pixels_by_cause);
}

/// Expects equality, bit by bit.
inline void expect_same(const Film& a, const Film& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_TRUE(a.radiance == b.radiance);
  EXPECT_TRUE(a.split_level == b.split_level);
  EXPECT_TRUE(a.cause == b.cause);
}

}  // namespace asos::test
