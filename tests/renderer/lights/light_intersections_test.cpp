#include "renderer/lights/light_intersections.h"

#include "tests/support/make_light.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace asos::test::light_intersections_test {
namespace {

/// A light of 2 x 1 in y = 2, centred at x = z = 0, facing down.
Light ceiling_light() {
  return make_panel({0, 2, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 0.5});
}

std::vector<LightIntersection> cuts_of(const World& world, const Light& light) {
  const PreparedLight prepared = prepare_light(light);
  return find_light_intersections(world, {&prepared, 1}).at(0);
}

double length_of(const std::vector<LightIntersection>& cuts) {
  double sum = 0.0;
  for (const LightIntersection& cut : cuts) sum += glm::distance(cut.from, cut.to);
  return sum;
}

World wall(double x, double bottom, double top) {
  World world;
  add_quad(world, glm::vec3(x, bottom, -4), glm::vec3(0, top - bottom, 0), glm::vec3(0, 0, 8),
           matte({0.5f, 0.5f, 0.5f}));
  return world;
}

TEST(LightIntersections, LieWhereASurfaceMeetsTheLightsPlane) {
  const std::vector<LightIntersection> cuts = cuts_of(wall(0.25, 0.0, 8.0), ceiling_light());
  ASSERT_FALSE(cuts.empty());
  for (const LightIntersection& cut : cuts) {
    for (const glm::dvec3 p : {cut.from, cut.to}) {
      EXPECT_NEAR(p.x, 0.25, 1e-7);
      EXPECT_NEAR(p.y, 2.0, 1e-7);
      EXPECT_LE(std::abs(p.z), 0.5 * (1.0 + 1.0 / 16.0) + 1e-7);
    }
  }
  EXPECT_NEAR(length_of(cuts), 1.0 + 1.0 / 16.0, 1e-6);
}

TEST(LightIntersections, AreFoundOnlyForCrossingSurfaces) {
  EXPECT_TRUE(cuts_of(wall(1.01, 0.0, 8.0), ceiling_light()).empty());
  EXPECT_TRUE(cuts_of(wall(0.25, 0.0, 1.999), ceiling_light()).empty());
  EXPECT_TRUE(cuts_of(wall(0.25, 2.001, 8.0), ceiling_light()).empty());
}

TEST(LightIntersections, AreWhereSurfacesEndOnTheSideThatShines) {
  EXPECT_FALSE(cuts_of(wall(0.25, 0.0, 2.0), ceiling_light()).empty());
  EXPECT_TRUE(cuts_of(wall(0.25, 2.0, 8.0), ceiling_light()).empty());
  Light both = ceiling_light();
  both.two_sided = true;
  EXPECT_FALSE(cuts_of(wall(0.25, 2.0, 8.0), both).empty());
}

TEST(LightIntersections, AreNotAlongTheOutlineNorInThePlane) {
  // A lampshade along the outline of a light in a ceiling.
  World world = wall(1.0, 0.0, 2.0);
  add_quad(world, {-9, 2, -9}, {18, 0, 0}, {0, 0, 18}, matte({0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(cuts_of(world, ceiling_light()).empty());
  Light triangle = ceiling_light();
  triangle.type = Light::Type::polygon;
  triangle.outlines = {{{0.25, 2, -0.75}, {0.25, 2, 0.75}, {-1, 2, 0}}};
  EXPECT_TRUE(cuts_of(wall(0.25, 0.0, 2.0), triangle).empty());
  EXPECT_FALSE(cuts_of(wall(0.125, 0.0, 2.0), triangle).empty());
  // Within the bounding rectangle, but outside the light.
  World beside;
  add_quad(beside, {-1.5f, 1.0f, 0.625f}, {0.875f, 0, 0}, {0, 2, 0}, matte({0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(cuts_of(beside, triangle).empty());
  EXPECT_FALSE(cuts_of(beside,
                       [&] {
                         Light larger = triangle;
                         larger.outlines = {{{1, 2, -2}, {1, 2, 2}, {-2, 2, 0.625}}};
                         return larger;
                       }())
                   .empty());
}

TEST(LightIntersections, AreNotOfTheLightsOwnPartNorOfLightsWithoutShadows) {
  Light light = ceiling_light();
  light.own_part = 0;
  EXPECT_TRUE(cuts_of(wall(0.25, 0.0, 8.0), light).empty());
  light.own_part = -1;
  light.casts_shadows = false;
  EXPECT_TRUE(cuts_of(wall(0.25, 0.0, 8.0), light).empty());
  light.casts_shadows = true;
  light.type = Light::Type::linear;
  EXPECT_TRUE(cuts_of(wall(0.25, 0.0, 8.0), light).empty());
}

// Intersections with a disk are as long as its chord.
TEST(LightIntersections, OfADiskAreChords) {
  Light disk = ceiling_light();
  disk.type = Light::Type::disk;
  disk.radius = 1.0;
  EXPECT_FALSE(cuts_of(wall(0.99, 0.0, 8.0), disk).empty());
  World corner;  // within the square around the disk only
  add_quad(corner, {0.75f, 0.0f, 0.875f}, {0.5f, 0, -0.125f}, {0, 8, 0}, matte({0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(cuts_of(corner, disk).empty());
}

TEST(LightIntersections, AreNotKeptBeyondWhatIsCutAlong) {
  World world;
  for (int i = 0; i < 1000; ++i) {
    const float x = static_cast<float>(i) / 1000.0f;
    add_triangle(world, {x, 1, 0}, {x, 3, 0}, {x, 3, 0.1f}, matte({0.5f, 0.5f, 0.5f}));
  }
  EXPECT_EQ(cuts_of(world, ceiling_light()).size(), most_light_intersections);
}

TEST(EnteredBalls, AreThoseThatATriangleOfAnotherPartReachesInto) {
  Light ball{.type = Light::Type::point, .radius = 1.0};
  const auto entered = [&](glm::vec3 corner, std::int32_t own_part) -> bool {
    World world;
    add_triangle(world, corner, corner + glm::vec3(4, 0, 0), corner + glm::vec3(0, 4, 0),
                 matte(glm::vec3(0.5f)));
    PreparedLight prepared = prepare_light(ball);
    prepared.own_part = own_part;
    return find_entered_balls(world, {&prepared, 1}).at(0);
  };
  EXPECT_TRUE(entered({-1, -1, 0.5f}, -1)) << "its face, all around the ball";
  EXPECT_FALSE(entered({-1, -1, 1.01f}, -1));
  EXPECT_TRUE(entered({0.5f, -1, 0}, -1)) << "an edge";
  EXPECT_FALSE(entered({0.72f, 0.72f, 0}, -1)) << "past a corner";
  EXPECT_FALSE(entered({-3.3f, -3.3f, 0}, -1)) << "only its box: past the longest edge";
  EXPECT_TRUE(entered({0.70f, 0.70f, 0}, -1)) << "a corner";
  EXPECT_FALSE(entered({-1, -1, 0.5f}, 0)) << "its own";
  ball.radius = 0.0;
  EXPECT_FALSE(entered({-1, -1, 0}, -1)) << "a point";
}

TEST(EnteredBalls, IncludeCapsulesAlongTheirWholeAxis) {
  Light capsule;
  capsule.type = Light::Type::linear;
  capsule.half_u = {3, 0, 0};
  capsule.radius = 0.2;
  const auto entered = [&](glm::vec3 corner) -> bool {
    World world;
    add_triangle(world, corner, corner + glm::vec3(0.1f, 0, 0), corner + glm::vec3(0, 0.1f, 0),
                 matte(glm::vec3(0.5f)));
    const PreparedLight prepared = prepare_light(capsule);
    return find_entered_balls(world, {&prepared, 1}).at(0);
  };
  for (const float x : {-3.15f, -2.0f, 0.4f, 3.1f}) EXPECT_TRUE(entered({x, 0, 0.05f})) << x;
  for (const float x : {-3.35f, -2.0f, 0.4f, 3.2f}) EXPECT_FALSE(entered({x, 0, 0.21f})) << x;
  EXPECT_FALSE(entered({3.21f, 0, 0}));
}

}  // namespace
}  // namespace asos::test::light_intersections_test
