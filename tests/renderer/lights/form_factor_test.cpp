#include "renderer/lights/form_factor.h"

#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

// Form factors known from the literature, and general properties.

namespace asos::form_factor_test {
namespace {

using std::numbers::pi;

using Corners = std::vector<glm::dvec3>;

const glm::dvec3 up(0, 1, 0);

/// A horizontal square at `height`, facing down: counter-clockwise seen from below.
Corners level_square(double half, double height) {
  return {
      {-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}};
}

TEST(ContourSide, IsPositiveCounterClockwiseAsSeenFromTheReceiver) {
  // A quarter of the horizon; looking up from the origin with x to the right, z is up the page.
  EXPECT_NEAR(contour_side({1, 0, 0}, {0, 0, 1}, up), 0.25 * pi, 1e-15);
  EXPECT_NEAR(contour_side({0, 0, 1}, {1, 0, 0}, up), -0.25 * pi, 1e-15);
}

TEST(ContourSide, KeepsItsDigitsForSmallAngles) {
  // sin(1e-9) equals 1e-9 in double precision: half of it, times the plane's cosine 1.
  EXPECT_NEAR(contour_side({1, 0, 0}, {1, 0, 1e-9}, up) / 0.5e-9, 1.0, 1e-14);
}

TEST(ContourSide, CountsNothingThroughTheReceiver) {
  EXPECT_EQ(contour_side({1, 0, 1}, {-1, 0, -1}, {0, 0, 1}), 0.0);
  EXPECT_EQ(contour_side({0, 0, 0}, {-1, 0, -1}, {0, 0, 1}), 0.0);
}

TEST(PolygonForm, IsThatOfAParallelSquareAboveItsCentre) {
  // Four times the corner form factor of a parallel rectangle with X = Y = half / height (Howell,
  // "A Catalog of Radiation Heat Transfer Configuration Factors", B-3).
  for (const double half : {1e-4, 0.3, 1.0, 20.0, 1e4}) {
    const double ratio = half / std::sqrt(1.0 + half * half);
    const double expected = 4.0 * ratio * std::atan(ratio);
    EXPECT_NEAR(polygon_form(level_square(half, 1.0), up) / expected, 1.0, 1e-7) << half;
  }
}

TEST(PolygonForm, FallsToNothingAsItSinksBelowTheHorizon) {
  // A wall half above the horizon has the form factor of its upper half.
  const Corners wall{{1, -1, 2}, {-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}};
  const Corners upper{{1, 0, 2}, {-1, 0, 2}, {-1, 1, 2}, {1, 1, 2}};
  EXPECT_NEAR(polygon_form(wall, up), polygon_form(upper, up), 1e-15);
  EXPECT_GT(std::abs(polygon_form(upper, up)), 0.01);
  EXPECT_EQ(polygon_form(level_square(1.0, -1.0), up), 0.0);
}

TEST(PolygonForm, IsThatOfTheHemisphereForAHugeLevelPolygon) {
  EXPECT_NEAR(polygon_form(level_square(1e9, 1.0), up), pi, 1e-8);
  EXPECT_NEAR(polygon_form(level_square(1e9, 1.0), {1, 0, 0}), 0.5 * pi, 1e-8);
}

TEST(PolygonForm, TakesHolesOff) {
  Corners hole = level_square(0.4, 1.0);
  const double inner = polygon_form(hole, up);
  std::reverse(hole.begin(), hole.end());
  EXPECT_NEAR(polygon_form(hole, up), -inner, 1e-15);
  EXPECT_GT(inner, 0.0);
}

/// A comb whose teeth cross the horizon: clipping leaves several parts.
TEST(PolygonForm, ClosesEveryPartOfAConcavePolygonThatTheHorizonCuts) {
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(1.0, 0.1, 0.0));
  Corners comb{{-2, 1, -2}};
  std::vector<Corners> parts;
  parts.push_back({{-2, 1, -2}, {-1, 1, -2}, {-1, 1, 2}, {-2, 1, 2}});
  for (int tooth = 0; tooth < 3; ++tooth) {
    const double z = -2.0 + 1.5 * tooth;
    comb.insert(comb.end(), {{2, 1, z}, {2, 1, z + 1}, {-1, 1, z + 1}});
    if (tooth < 2) comb.push_back({-1, 1, z + 1.5});
    parts.push_back({{-1, 1, z}, {2, 1, z}, {2, 1, z + 1}, {-1, 1, z + 1}});
  }
  comb.insert(comb.end(), {{-1, 1, 2}, {-2, 1, 2}});
  for (const glm::dvec3& normal : {tilted, up, -tilted, glm::normalize(glm::dvec3(0.2, 0.1, 1))}) {
    double sum = 0.0;
    for (const Corners& part : parts) sum += polygon_form(part, normal);
    EXPECT_NEAR(polygon_form(comb, normal), sum, 1e-14);
    EXPECT_GT(sum, 0.05);
  }
}

TEST(DiskForm, IsThatOfADiskOnTheAxis) {
  for (const double radius : {1e-4, 0.3, 1.0, 20.0, 1e4}) {
    const double expected = pi * radius * radius / (radius * radius + 1.0);
    EXPECT_NEAR(disk_form({0, 1, 0}, -up, radius, up) / expected, 1.0, 1e-14) << radius;
  }
  EXPECT_EQ(disk_form({0, 1, 0}, up, 1.0, up), 0.0) << "from behind";
  EXPECT_EQ(disk_form({3, 0, 0}, up, 1.0, up), 0.0) << "edge-on";
}

TEST(DiskForm, IsTheLimitOfPolygons) {
  test::RandomSpace random(5);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 facing = random.direction();
    const glm::dvec3 u = random.perpendicular(facing);
    const glm::dvec3 v = glm::cross(facing, u);
    const double radius = random.between(0.1, 3.0);
    const glm::dvec3 centre = random.direction() * 1.5;
    const Receiver receiver =
        random.receiver(centre + facing * random.between(0.2, 2.0) + u, centre, i);
    // The polygon has the disk's area; the relative error goes with the square of the angle.
    constexpr int corners = 4000;
    const double angle = 2.0 * pi / corners;
    Corners rim;
    for (int k = 0; k < corners; ++k) {
      rim.push_back(centre + radius * std::sqrt(angle / std::sin(angle)) *
                                 (std::cos(k * angle) * u + std::sin(k * angle) * v));
    }
    EXPECT_NEAR(disk_form(centre, facing, radius, receiver), polygon_form(rim, receiver), 2e-5)
        << i;
  }
}

TEST(BallForm, IsThatOfABallOverhead) {
  for (const double radius : {1e-4, 0.3, 0.999}) {
    EXPECT_NEAR(ball_form({0, 1, 0}, radius, up) / (pi * radius * radius), 1.0, 1e-14) << radius;
  }
}

TEST(BallForm, IsTheUpperHalfOfTheCapWhereTheHorizonHalvesTheBall) {
  // Projected onto the horizon: the lune of a half cap of half angle a (Snyder 1996).
  for (const double a : {0.01, 0.5, 1.5}) {
    const double expected = a - std::sin(a) * std::cos(a);
    EXPECT_NEAR(ball_form({1, 0, 0}, std::sin(a), up), expected, 1e-9 * expected + 1e-15) << a;
  }
}

TEST(BallForm, IsPiInsideAndAWedgeBetweenTwoHorizons) {
  EXPECT_DOUBLE_EQ(ball_form({0.2, 0.3, 0}, 1.0, up), pi);
  EXPECT_DOUBLE_EQ(ball_form({0.0, 0.0, 0}, 1.0, up), pi);
  EXPECT_NEAR(ball_form({0.2, 0.3, 0}, 1.0, Receiver{{0, 0, 0}, up, {1, 0, 0}}), 0.5 * pi, 1e-15);
}

TEST(LineForm, IsThatOfALevelTubeAboveItsMiddle) {
  // Above an endless line of one candela per metre: pi / (2 h) with the sine, 2 / h without.
  const Receiver receiver{{0, 0, 0}, up, up};
  for (const double h : {1e-3, 1.0, 50.0}) {
    EXPECT_NEAR(line_form({-1e9, h, 0}, {1e9, h, 0}, true, receiver) * h, 0.5 * pi, 1e-7) << h;
    EXPECT_NEAR(line_form({-1e9, h, 0}, {1e9, h, 0}, false, receiver) * h, 2.0, 1e-7) << h;
  }
}

TEST(LineForm, GivesNothingAlongATubeAndInverseSquareAlongPoints) {
  const Receiver receiver{{0, 0, 0}, up, up};
  EXPECT_EQ(line_form({0, 1, 0}, {0, 2, 0}, true, receiver), 0.0);
  EXPECT_NEAR(line_form({0, 1, 0}, {0, 2, 0}, false, receiver), 0.5, 1e-15);  // int dy / y^2
  EXPECT_EQ(line_form({0, -1, 0}, {0, 2, 0}, false, receiver), 0.0) << "on the line itself";
}

/// Forms change little from step to step, a thousandth of the light's size, while it crosses the
/// horizons.
TEST(Forms, AreContinuousAcrossBothHorizons) {
  const glm::dvec3 geometric = glm::normalize(glm::dvec3(0.3, 1.0, 0.1));
  for (const Receiver& receiver :
       {Receiver{{0, 0, 0}, up, up}, Receiver{{0, 0, 0}, up, geometric}}) {
    std::array<double, 4> last{};
    for (int i = 0; i <= 4000; ++i) {
      const double y = 2.0 - 0.001 * i;
      const glm::dvec3 centre(0.4, y, 1.5);
      const glm::dvec3 facing = glm::normalize(glm::dvec3(-0.2, -0.3, -1.0));
      const glm::dvec3 u(facing.z, 0, -facing.x);
      const glm::dvec3 v = glm::cross(facing, u);
      const Corners square{centre - u - v, centre + u - v, centre + u + v, centre - u + v};
      const std::array<double, 4> now{
          polygon_form(square, receiver), disk_form(centre, facing, 1.0, receiver),
          ball_form(centre, 1.0, receiver), line_form(centre - v, centre + v, true, receiver)};
      for (std::size_t k = 0; k < now.size(); ++k) {
        ASSERT_GE(now[k], 0.0) << k << " at " << y;
        if (i > 0) {
          ASSERT_LT(std::abs(now[k] - last[k]), 0.004) << k << " at " << y;
        } else {
          ASSERT_GT(now[k], 0.05) << k;
        }
      }
      last = now;
    }
    for (const double form : last) EXPECT_LT(form, 0.05);
  }
}

}  // namespace
}  // namespace asos::form_factor_test
