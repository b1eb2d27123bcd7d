#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace asos::extreme_rays_test {
namespace {

// Failed assertions in Debian's Embree, for numbers out of its range, end the program and this
// test.

constexpr float infinity = std::numeric_limits<float>::infinity();

World square_of(float size) {
  World world;
  test::add_quad(world, {-size, -size, 0}, {2 * size, 0, 0}, {0, 2 * size, 0},
                 test::matte(glm::vec3(1)));
  return world;
}

/// Valid rays except for one component of origin or direction, which is `number`.
std::vector<Ray> rays_with(float number) {
  std::vector<Ray> rays;
  for (int i = 0; i < 6; ++i) {
    for (const float sign : {1.0f, -1.0f}) {
      Ray ray{.origin = {0, 0, 1}, .direction = {0, 0, -1}};
      (i < 3 ? ray.origin : ray.direction)[i % 3] = sign * number;
      rays.push_back(ray);
    }
  }
  return rays;
}

TEST(ExtremeRays, NoNumberOfARayEndsTheProgram) {
  // Lengths in tiny and huge worlds are scaled for Embree.
  for (const float size : {1e-30f, 1e-6f, 1.0f, 1e6f, 5e14f}) {
    const World world = square_of(size);
    RayScene scene = test::build(world);
    for (const int width : {1, 4, 8, 16}) {
      scene.set_packet_width(width);
      for (const float number : {1e15f, 1.7e18f, 1.8e18f, 1.844e18f, 1.9e18f, 1e19f, 3e38f}) {
        const std::vector<Ray> rays = rays_with(number);
        std::vector<Hit> hits(rays.size());
        std::vector<glm::vec3> shares(rays.size());
        scene.closest(rays, hits);
        scene.transmittance(rays, shares);
        for (std::size_t i = 0; i < rays.size(); ++i) {
          EXPECT_FALSE(std::isnan(hits[i].t)) << size << " " << number << " ray " << i;
          EXPECT_TRUE(shares[i] == glm::vec3(0.0f) || shares[i] == glm::vec3(1.0f))
              << size << " " << number;
        }
      }
    }
  }
}

TEST(ExtremeRays, AWorldOfTheLargestSizeIsMetFromOutside) {
  const float size = 5e14f;
  const World world = square_of(size);
  const RayScene scene = test::build(world);
  // The distance at which rays start: see View.
  Ray ray = test::down(0.25f * size, 0.25f * size, 1024.0f * size);
  const Hit hit = scene.closest(ray);
  ASSERT_TRUE(hit.valid());
  EXPECT_FLOAT_EQ(hit.t, 1024.0f * size);
  EXPECT_EQ(scene.transmittance(ray).x, 0.0f);
}

/// `count` surfaces that are the same single point, with or without a square.
World points(std::size_t count, const Material& material, bool beside_a_square) {
  World world = beside_a_square ? square_of(1.0f) : World{};
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 p(0.25f, 0.5f, 2.0f);
    test::add_triangle(world, p, p, p, material);
  }
  return world;
}

void expect_points_missed(std::size_t count, bool beside, BvhPurpose use) {
  const Ray ray = test::down(0.25f, 0.5f, 3.0f);
  for (const Material& material :
       {test::matte(glm::vec3(1)), test::blended(0.5f), test::masked(0.5f)}) {
    const World world = points(count, material, beside);
    const RayScene scene = test::build(world, test::factor_alpha, {}, use);
    const Hit hit = scene.closest(ray);
    EXPECT_EQ(hit.valid(), beside) << count;
    if (hit.valid()) {
      EXPECT_FLOAT_EQ(hit.t, 3.0f) << count;
    }
    EXPECT_EQ(scene.transmittance(ray).x, beside ? 0.0f : 1.0f) << count;
  }
  // The last part belongs to a light.
  const World world = points(count, test::matte(glm::vec3(1)), beside);
  const auto last = static_cast<std::int32_t>(world.parts.size()) - 1;
  const RayScene scene = test::build(world, test::factor_alpha, {test::lamp_of(last)}, use);
  EXPECT_EQ(scene.closest(ray).valid(), beside) << count;
}

TEST(ExtremeRays, SurfacesThatCollapseToOnePointAreMissed) {
  for (const BvhPurpose use : {BvhPurpose::lasting, BvhPurpose::moment})
    for (const std::size_t count : {1, 2, 3, 4, 5, 8, 9, 16, 33, 1000, 1500, 20'000})
      for (const bool beside : {false, true}) expect_points_missed(count, beside, use);
}

TEST(ExtremeRays, SurfacesOfOneMiddleAreAllMet) {
  for (const std::size_t count : {2, 3, 8, 9, 33, 1000, 1500}) {
    World world;
    for (std::size_t i = 0; i < count; ++i) {
      const float size = 1.0f + 0.5f * static_cast<float>(i) / static_cast<float>(count);
      test::add_triangle(world, {-size, -size, 0}, {size, -size, 0}, {0, size, 0},
                         test::blended(0.5f));
    }
    for (const BvhPurpose use : {BvhPurpose::lasting, BvhPurpose::moment}) {
      const RayScene scene = test::build(world, test::factor_alpha, {}, use);
      const float left = scene.transmittance(test::down(0.0f, -0.5f)).x;
      EXPECT_FLOAT_EQ(left, count > 15 ? 0.0f : std::pow(0.5f, static_cast<float>(count))) << count;
    }
  }
}

TEST(ExtremeRays, ShapesInOnePlaceAreMet) {
  for (const std::size_t count : {2, 3, 9, 64, 1000}) {
    World world;
    for (std::size_t i = 0; i < count; ++i)
      test::add_shape(world, test::sphere(1.0), glm::dmat4(1.0), test::matte(glm::vec3(0.5f)));
    const RayScene scene = test::build(world);
    const Hit hit = scene.closest(test::down(0.0f, 0.0f, 3.0f));
    ASSERT_TRUE(hit.valid()) << count;
    EXPECT_FLOAT_EQ(hit.t, 2.0f) << count;
    EXPECT_EQ(scene.transmittance(test::down(0.3f, 0.2f, infinity)).x, 1.0f);
  }
}

}  // namespace
}  // namespace asos::extreme_rays_test
