#include "renderer/shading/footprint.h"

#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asos {
namespace {

Hit on_triangle(std::uint32_t triangle) {
  Hit hit;
  hit.triangle = triangle;
  return hit;
}

struct Plane {
  glm::vec3 point;
  glm::vec3 normal;

  [[nodiscard]] float distance(const Ray& ray) const {
    return glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal);
  }
  [[nodiscard]] glm::vec3 hit(const Ray& ray) const { return ray.at(distance(ray)); }
};

const Plane tilted{{0.3f, -0.2f, -4.0f}, glm::normalize(glm::vec3(0.5f, 0.7f, 0.4f))};

Patch patch_at(const View& view, const Plane& plane, double x, double y, float side) {
  const Ray ray = view.ray(x, y);
  return patch_on_plane(PixelSpacing::of(view), ray.direction, plane.distance(ray), plane.normal,
                        side);
}

TEST(Footprint, FollowsTheRaysOfNeighbouringPixels) {
  // Central differences over half a pixel have an error of the third derivative. A pixel is 1/500
  // of the distance here: about 1e-6 of a step, plus about 1e-4 for the rounding of hits.
  for (const Camera& camera :
       {test::look_at({0, 0.5, 1}, {0, 0, -4}, 0.8), test::orthographic(3.0)}) {
    const View view(camera, 640, 480);
    for (const auto& [x, y] : {std::pair{320.5, 240.5}, {40.5, 30.5}, {600.5, 450.5}}) {
      const Patch patch = patch_at(view, tilted, x, y, 1.0f);
      const glm::vec3 right = tilted.hit(view.ray(x + 0.5, y)) - tilted.hit(view.ray(x - 0.5, y));
      const glm::vec3 down = tilted.hit(view.ray(x, y + 0.5)) - tilted.hit(view.ray(x, y - 0.5));
      EXPECT_LT(glm::length(patch.right - right), 1e-3f * glm::length(right)) << x << " " << y;
      EXPECT_LT(glm::length(patch.down - down), 1e-3f * glm::length(down)) << x << " " << y;
    }
  }
}

TEST(Footprint, GrowsWithTheSquareThatItStandsFor) {
  const View view(test::look_at({0, 0.5, 1}, {0, 0, -4}, 0.8), 640, 480);
  const Patch whole = patch_at(view, tilted, 100.5, 90.5, 1.0f);
  const Patch quarter = patch_at(view, tilted, 100.5, 90.5, 0.25f);
  EXPECT_EQ(0.25f * whole.right, quarter.right);
  EXPECT_EQ(0.25f * whole.down, quarter.down);
  EXPECT_EQ(patch_at(view, tilted, 100.5, 90.5, 0.0f).right, glm::vec3(0.0f));
}

TEST(Footprint, IsBoundedWhereAPlaneIsSeenEdgeOn) {
  const View view(test::orthographic(4.8), 640, 480);  // a pixel is 0.01 wide
  for (const float tilt : {0.0f, 1e-12f, 1e-3f, -1e-3f}) {
    const Plane edge_on{{0, 0, 0}, glm::normalize(glm::vec3(1, 0, tilt))};
    const Patch patch =
        patch_on_plane(PixelSpacing::of(view), {0, 0, -1}, 10.0f, edge_on.normal, 1.0f);
    // The maximum length: the pixel divided by the limit's cosine, and the pixel's own width.
    EXPECT_NEAR(glm::length(patch.right), 0.01f * std::hypot(1.0f, 1.0f / steepest_patch), 1e-4f);
    EXPECT_NEAR(glm::length(patch.down), 0.01f, 1e-6f);
  }
}

TEST(Footprint, InATrianglesCoordinatesGivesThePatchBack) {
  World world;
  test::add_triangle(world, {1, 2, 3}, {4, 2.5f, 2}, {0.5f, 6, 4}, Material{});
  const glm::vec3 e1(3, 0.5f, -1);
  const glm::vec3 e2(-0.5f, 4, 1);
  const Footprint f = footprint_on(world, on_triangle(0), {0.25f * e1 - 0.5f * e2, 2.0f * e2});
  EXPECT_NEAR(f.right.x, 0.25f, 1e-6f);
  EXPECT_NEAR(f.right.y, -0.5f, 1e-6f);
  EXPECT_NEAR(f.down.x, 0.0f, 1e-6f);
  EXPECT_NEAR(f.down.y, 2.0f, 1e-6f);
  const Steps<float> steps(f, 10.0f, 14.0f, 12.0f);
  EXPECT_NEAR(steps.right, 0.25f * 4.0f - 0.5f * 2.0f, 1e-5f);
  EXPECT_NEAR(steps.down, 2.0f * 2.0f, 1e-5f);
}

TEST(Footprint, IsAPointWhereItCannotBeKnown) {
  World world;
  test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Material{});
  test::add_triangle(world, {0, 0, 0}, {1, 1, 1}, {2, 2, 2}, Material{});
  const Patch good{{0.1f, 0, 0}, {0, 0.1f, 0}};
  EXPECT_FALSE(footprint_on(world, on_triangle(0), good).point());
  EXPECT_TRUE(footprint_on(world, on_triangle(1), good).point());  // no area
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_TRUE(footprint_on(world, on_triangle(0), {{bad, 0, 0}, {0, 0.1f, 0}}).point());
    const Patch far = patch_on_plane({true, {0, 0, -1}, {0.01f, 0, 0}, {0, 0.01f, 0}}, {0, 0, -1},
                                     bad, {0, 0, 1}, 1.0f);
    EXPECT_TRUE(footprint_on(world, on_triangle(0), far).point());
  }
}

}  // namespace
}  // namespace asos
