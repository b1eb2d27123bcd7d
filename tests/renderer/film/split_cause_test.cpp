#include "renderer/film/split_cause.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace asos {
namespace {

glm::dvec3 linear(glm::u8vec3 colour) {
  glm::dvec3 c;
  for (int i = 0; i < 3; ++i) {
    const double encoded = colour[i] / 255.0;
    c[i] = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  }
  return c;
}

// CIE L*a*b* under D65.
glm::dvec3 lab(glm::dvec3 rgb) {
  const glm::dmat3 xyz_from_rgb(0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722,
                                0.9505);
  const glm::dvec3 relative = xyz_from_rgb * glm::max(rgb, 0.0) / glm::dvec3(0.9505, 1.0, 1.089);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const glm::dvec3 v(f(relative.x), f(relative.y), f(relative.z));
  return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
}

/// The colour that dichromats see, in linear RGB: Vienot, Brettel and Mollon, "Digital video
/// colourmaps for checking the legibility of displays by dichromats" (1999).
glm::dvec3 as_seen_by(int missing_cone, glm::dvec3 rgb) {
  const glm::dmat3 lms_from_rgb(17.8824, 3.45565, 0.0299566, 43.5161, 27.1554, 0.184309, 4.11935,
                                3.86714, 1.46709);
  glm::dvec3 lms = lms_from_rgb * rgb;
  if (missing_cone == 0) lms.x = 2.02344 * lms.y - 2.52581 * lms.z;
  if (missing_cone == 1) lms.y = 0.494207 * lms.x + 1.24827 * lms.z;
  return glm::inverse(lms_from_rgb) * lms;
}

TEST(SplitCauseColours, CanBeToldApartByEveryone) {
  // A difference of about 2.3 is just noticeable; 10 is visible at a glance.
  for (const int missing : {-1, 0, 1}) {
    for (std::size_t i = 0; i < split_cause_count; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const auto seen = [&](std::size_t cause) {
          return lab(
              as_seen_by(missing, linear(split_cause_colour(static_cast<SplitCause>(cause)))));
        };
        EXPECT_GT(glm::distance(seen(i), seen(k)), 10.0)
            << split_cause_names[i] << " and " << split_cause_names[k] << ", cone " << missing;
      }
    }
  }
}

TEST(SplitCauseColours, OnlyNoneIsBlack) {
  EXPECT_EQ(split_cause_colour(SplitCause::none), glm::u8vec3(0));
  for (std::size_t i = 1; i < split_cause_count; ++i)
    EXPECT_NE(split_cause_colour(static_cast<SplitCause>(i)), glm::u8vec3(0));
}

TEST(SplitCauseNames, AreAllDifferent) {
  const std::set<std::string> names(split_cause_names.begin(), split_cause_names.end());
  EXPECT_EQ(names.size(), split_cause_count);
  EXPECT_STREQ(name_of(SplitCause::none), "none");
  EXPECT_STREQ(name_of(SplitCause::intersection), "intersection");
  EXPECT_STREQ(name_of(SplitCause::depth_limit), "depth_limit");
}

}  // namespace
}  // namespace asos
