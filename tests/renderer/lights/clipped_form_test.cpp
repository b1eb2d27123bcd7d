#include "renderer/lights/clipped_form.h"

#include "renderer/lights/form_factor.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

// Forms above three horizons against those above two, and ellipses against polygons of many sides.

namespace asos::clipped_form_test {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 up(0.0, 0.0, 1.0);

Horizons horizons(std::initializer_list<glm::dvec3> more) {
  Horizons all;
  for (const glm::dvec3& normal : more) all.add(normal);
  return all;
}

std::vector<glm::dvec3> ellipse(glm::dvec3 centre, glm::dvec3 a, glm::dvec3 b, int sides) {
  // Of the ellipse's own area, so that the error goes with the sides' fourth power.
  const double step = 2.0 * pi / sides;
  const double grown = std::sqrt(step / std::sin(step));
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < sides; ++i)
    corners.push_back(centre + grown * (std::cos(i * step) * a + std::sin(i * step) * b));
  return corners;
}

TEST(ClippedForm, KeepsHorizonsThatDiffer) {
  EXPECT_EQ(horizons({}).normals().size(), 1u);
  EXPECT_EQ(horizons({up, 5.0 * up}).normals().size(), 1u);
  EXPECT_EQ(horizons({{0, 0, -1}}).normals().size(), 2u);
  EXPECT_EQ(horizons({{1e-3, 0, 1}, {1e-3, 0, 1}}).normals().size(), 2u);
  EXPECT_EQ(horizons({{1e-3, 0, 1}, {2e-3, 0, 1}}).normals().size(), 3u);
  EXPECT_EQ(horizons({glm::dvec3(0.0)}).normals().size(), 1u);
}

TEST(ClippedForm, OfAllDirectionsIsThatOfALune) {
  EXPECT_NEAR(whole_form(horizons({})), pi, 1e-12);
  test::RandomSpace random(7);
  for (int round = 0; round < 50; ++round) {
    const glm::dvec3 normal = random.direction();
    EXPECT_NEAR(whole_form(horizons({normal})), 0.5 * pi * (1.0 + normal.z), 1e-12) << round;
    // What lies below a third one is what is left of the lune.
    const glm::dvec3 third = random.direction();
    EXPECT_NEAR(whole_form(horizons({normal, third})) + whole_form(horizons({normal, -third})),
                whole_form(horizons({normal})), 1e-12)
        << round;
  }
}

TEST(ClippedForm, PolygonsAreThoseOfTwoHorizons) {
  test::RandomSpace random(8);
  int lit = 0;
  for (int round = 0; round < 200; ++round) {
    const glm::dvec3 centre = random.direction();
    const glm::dvec3 a = random.between(0.1, 2.0) * random.direction();
    const glm::dvec3 b = random.between(0.1, 2.0) * random.direction();
    // Concave.
    const std::vector<glm::dvec3> corners{centre - a - b, centre + a - b, centre + a + b,
                                          centre + 0.2 * a - 0.3 * b, centre - a + b};
    const glm::dvec3 second = random.direction();
    const Receiver receiver{glm::dvec3(0.0), up, second};
    const double expected = polygon_form(corners, receiver);
    EXPECT_NEAR(polygon_form(corners, horizons({second})), expected, 1e-12) << round;
    if (std::abs(expected) > 1e-3) ++lit;
    const glm::dvec3 third = random.direction();
    EXPECT_NEAR(polygon_form(corners, horizons({second, third})) +
                    polygon_form(corners, horizons({second, -third})),
                expected, 1e-12)
        << round;
  }
  EXPECT_GT(lit, 60);
}

TEST(ClippedForm, CirclesAreDisks) {
  test::RandomSpace random(9);
  int lit = 0;
  for (int round = 0; round < 300; ++round) {
    const double radius = std::pow(10.0, random.between(-3.5, 1.5));
    const glm::dvec3 facing = random.direction();
    const glm::dvec3 u = random.perpendicular(facing);
    const glm::dvec3 centre = -random.between(0.1, 1.0) * facing +
                              random.between(0.0, 1.5) * random.perpendicular(facing);
    const glm::dvec3 second = round % 3 == 0 ? up : random.direction();
    const double expected =
        disk_form(centre, facing, radius, Receiver{glm::dvec3(0.0), up, second});
    EXPECT_NEAR(
        ellipse_form(centre, radius * u, radius * glm::cross(facing, u), horizons({second})),
        expected, 1e-7 * expected + 1e-12)
        << round << " radius " << radius;
    if (expected > 1e-9) ++lit;
  }
  EXPECT_GT(lit, 100);
}

TEST(ClippedForm, EllipsesArePolygonsOfManySides) {
  test::RandomSpace random(10);
  int lit = 0;
  int cut = 0;
  for (int round = 0; round < 300; ++round) {
    const double size = std::pow(10.0, random.between(-2.0, 0.7));
    const glm::dvec3 centre = random.direction();
    const glm::dvec3 a = size * random.direction();
    const glm::dvec3 b = size * random.between(0.05, 1.0) * random.direction();
    const Horizons three = horizons({random.direction(), random.direction()});
    const double expected = std::abs(polygon_form(ellipse(centre, a, b, 4000), three));
    const double whole = std::abs(polygon_form(ellipse(centre, a, b, 4000), horizons({})));
    EXPECT_NEAR(ellipse_form(centre, a, b, three), expected, 1e-5 * (expected + whole)) << round;
    if (expected > 1e-6) ++lit;
    if (expected > 1e-6 && expected < 0.9 * whole) ++cut;
  }
  EXPECT_GT(lit, 40);
  EXPECT_GT(cut, 25);
}

TEST(ClippedForm, SmallEllipsesMeetTheirMiddle) {
  const glm::dvec3 centre(0.3, -0.2, 0.6);
  const glm::dvec3 a(0.4, 0.7, -0.1);
  const glm::dvec3 b(-0.5, 0.2, 0.3);
  double last = 0.0;
  for (const double size : {1e-3, 2e-4, 5e-5, 1e-8}) {
    const double density = ellipse_form(centre, size * a, size * b, {}) / (size * size);
    if (last != 0.0) {
      EXPECT_NEAR(density, last, 1e-5 * last) << size;
    }
    last = density;
  }
  EXPECT_GT(last, 0.1);
}

TEST(ClippedForm, IsFiniteForWhatHasNoSize) {
  const glm::dvec3 zero(0.0);
  const glm::dvec3 a(1, 0, 0);
  EXPECT_EQ(ellipse_form(zero, a, {0, 1, 0}, {}), 0.0);
  EXPECT_EQ(ellipse_form({0, 0, 1}, zero, zero, {}), 0.0);
  EXPECT_EQ(ellipse_form({0, 0, 1}, a, a, {}), 0.0);
  EXPECT_EQ(ellipse_form({2, 0, 0}, a, {0, 1, 0}, {}), 0.0) << "in its own plane";
  for (const double scale : {1e-12, 1e12}) {
    EXPECT_NEAR(ellipse_form({0, 0, scale}, scale * a, {0, scale, 0}, {}), 0.5 * pi, 1e-9);
    EXPECT_TRUE(std::isfinite(ellipse_form({1, 1, 1}, scale * a, {0, scale, 0}, {}))) << scale;
  }
  EXPECT_EQ(polygon_form(std::vector<glm::dvec3>{zero, zero, zero}, Horizons{}), 0.0);
}

TEST(ClippedForm, CutsLines) {
  const LinePart all = part_above({1, 0, 1}, {-1, 0, 2}, {});
  EXPECT_EQ(all.first, 0.0);
  EXPECT_EQ(all.second, 1.0);
  const LinePart some = part_above({3, 0, -1}, {-1, 0, 3}, horizons({{1, 0, 0}}));
  EXPECT_DOUBLE_EQ(some.first, 0.25);
  EXPECT_DOUBLE_EQ(some.second, 0.75);
  const LinePart none = part_above({1, 0, -1}, {2, 0, -3}, {});
  EXPECT_GE(none.first, none.second);
}

}  // namespace
}  // namespace asos::clipped_form_test
