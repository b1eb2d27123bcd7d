#include "renderer/features/shape_intersections.h"

#include "renderer/features/feature_set.h"
#include "tests/support/shape_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asos::test {
namespace {

ShapeIntersections crossings(const std::vector<Shape>& shapes,
                             const std::vector<glm::dmat4>& places) {
  World world;
  for (std::size_t i = 0; i < shapes.size(); ++i) add_shape(world, shapes[i], places[i], {});
  return find_shape_intersections(world);
}

double length_of(const ShapeIntersections& found) {
  double sum = 0.0;
  for (const IntersectionLine& line : found.lines)
    sum += glm::distance(glm::dvec3(line.a), glm::dvec3(line.b));
  return sum;
}

glm::dmat4 moved(double x, double y, double z) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

TEST(ShapeIntersections, ShapesThatCoincideHaveNone) {
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(3, 1, 2)));
  const glm::dmat4 squeezed = glm::scale(glm::dmat4(1.0), glm::dvec3(3.0, 0.2, 1.1));
  for (const double size : {1e-6, 1.0, 1e6}) {
    const glm::dmat4 sized = glm::scale(glm::dmat4(1.0), glm::dvec3(size));
    for (const glm::dmat4& place : {moved(0, 0, 0), moved(3e5 * size, -7e5 * size, 1e5 * size)}) {
      const glm::dmat4 at = place * sized;
      EXPECT_TRUE(crossings({sphere(1), sphere(1)}, {at, at}).lines.empty()) << size;
      EXPECT_TRUE(crossings({sphere(1), sphere(1)}, {at, at * turned}).lines.empty()) << size;
      EXPECT_TRUE(crossings({sphere(1), sphere(2)},
                            {at * squeezed * turned,
                             at * squeezed * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5))})
                      .lines.empty())
          << size;
      EXPECT_TRUE(crossings({cylinder(2, 1, 1), cylinder(2, 1, 1)}, {at, at}).lines.empty());
      EXPECT_TRUE(crossings({cylinder(2, 1, 0.5), cylinder(2, 1, 0.5)}, {at, at}).lines.empty());
    }
  }
}

// Dropping coincident surfaces must not drop their intersection.
TEST(ShapeIntersections, ShapesThatNearlyCoincideCrossInOneLine) {
  for (const double apart : {1e-6, 1e-3, 0.5}) {
    const ShapeIntersections found =
        crossings({sphere(1), sphere(1)}, {moved(0, 0, 0), moved(0, apart, 0)});
    const double radius = std::sqrt(1.0 - 0.25 * apart * apart);
    EXPECT_NEAR(length_of(found), 2.0 * std::numbers::pi * radius, 2e-3) << apart;
    for (const IntersectionLine& line : found.lines) {
      EXPECT_NEAR(line.a.y, 0.5 * apart, apart > 1e-5 ? 2e-6 : 2e-3) << apart;
      EXPECT_NEAR(glm::length(line.a), 1.0, 1e-6);
    }
  }
}

// Sixty-four spheres in one place once took twenty seconds, because of lines from rounding errors.
TEST(ShapeIntersections, ManyShapesInOnePlaceHaveNoBoundaryBetweenThem) {
  World world;
  for (int i = 0; i < 64; ++i) add_shape(world, sphere(1), moved(0.1, 0.2, 0.3), {});
  EXPECT_EQ(FeatureSet(world).counts().intersection, 0u);
}

}  // namespace
}  // namespace asos::test
