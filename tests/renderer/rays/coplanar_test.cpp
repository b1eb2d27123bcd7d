#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

// For coplanar triangles a rule decides which one is in front, not rounding.

namespace asos::coplanar_test {
namespace {

using test::add_quad;
using test::matte;

/// A plane through the origin with any orientation.
struct Tilt {
  glm::vec3 right, up, normal;

  explicit Tilt(unsigned seed) {
    std::mt19937 rng(seed);
    std::normal_distribution<double> any;
    const glm::dvec3 n = glm::normalize(glm::dvec3(any(rng), any(rng), any(rng)));
    const glm::dvec3 r = glm::normalize(glm::cross(n, glm::dvec3(any(rng), any(rng), any(rng))));
    right = glm::vec3(r), up = glm::vec3(glm::cross(n, r)), normal = glm::vec3(n);
  }
  void add(World& world, float half, const Material& material, float height = 0.0f) const {
    add_quad(world, height * normal - half * (right + up), 2.0f * half * right, 2.0f * half * up,
             material);
  }
};

Material both_sides(AlphaMode mode) {
  Material m = matte(glm::vec3(1.0f));
  m.double_sided = true;
  m.alpha_mode = mode;
  return m;
}

/// Rays to points within `half` of the plane's centre, from either side.
std::vector<Ray> rays_to(const Tilt& tilt, float half) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  std::vector<Ray> rays;
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 at = half * (any(rng) * tilt.right + any(rng) * tilt.up);
    Ray ray;
    ray.origin = 3.0f * (any(rng) * tilt.right + any(rng) * tilt.up) +
                 (i % 2 == 0 ? 5.0f : -5.0f) * tilt.normal;
    ray.direction = glm::normalize(at - ray.origin);
    rays.push_back(ray);
  }
  return rays;
}

/// The part that each ray hits.
std::vector<std::uint32_t> parts_met(const World& world, const std::vector<Ray>& rays) {
  const RayScene scene = test::build(world);
  std::vector<Hit> hits(rays.size());
  scene.closest(rays, hits);
  std::vector<std::uint32_t> parts;
  for (const Hit& hit : hits)
    parts.push_back(hit.valid() ? world.triangle_part[hit.triangle] : ~0u);
  return parts;
}

TEST(Coplanar, TheLaterPrimitiveIsInFront) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Tilt tilt(seed);
    for (const bool small_first : {true, false}) {
      World world;
      tilt.add(world, small_first ? 0.4f : 1.0f, both_sides(AlphaMode::opaque));
      tilt.add(world, small_first ? 1.0f : 0.4f, both_sides(AlphaMode::opaque));
      for (const std::uint32_t part : parts_met(world, rays_to(tilt, 0.39f)))
        ASSERT_EQ(part, 1u) << seed;
    }
  }
}

TEST(Coplanar, BlendedAndCutOutOnesAreInFrontOfOpaqueOnes) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Tilt tilt(seed);
    for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
      World world;
      tilt.add(world, 0.4f, both_sides(mode));
      tilt.add(world, 1.0f, both_sides(AlphaMode::opaque));
      for (const std::uint32_t part : parts_met(world, rays_to(tilt, 0.39f)))
        ASSERT_EQ(part, 0u) << seed;
    }
  }
}

TEST(Coplanar, AllInOnePlaceFollowEachOther) {
  const Tilt tilt(3);
  World world;
  tilt.add(world, 0.5f, both_sides(AlphaMode::blend));
  tilt.add(world, 1.0f, both_sides(AlphaMode::opaque));
  tilt.add(world, 0.7f, both_sides(AlphaMode::blend));
  tilt.add(world, 0.6f, both_sides(AlphaMode::opaque));
  const RayScene scene = test::build(world);
  for (const Ray& ray : rays_to(tilt, 0.49f)) {
    const Hit hit = scene.closest(ray);
    ASSERT_TRUE(scene.is_coplanar(hit));
    std::vector<Hit> met;
    scene.in_place(ray, hit, Culling::none, met);
    ASSERT_EQ(met.size(), 4u);
    std::vector<std::uint32_t> parts;
    for (const Hit& one : met) parts.push_back(world.triangle_part[one.triangle]);
    ASSERT_EQ(parts, (std::vector<std::uint32_t>{2, 0, 3, 1}));
  }
}

TEST(Coplanar, NeighboursAndNearPlanesAreNot) {
  const Tilt tilt(5);
  World world;
  const Material m = both_sides(AlphaMode::opaque);
  const glm::vec3 corner(-1.0f, -1.0f, 0.0f);
  for (int i = 0; i < 4; ++i)
    add_quad(world, corner + glm::vec3(i % 2, i / 2, 0), {1, 0, 0}, {0, 1, 0}, m);
  add_quad(world, corner + glm::vec3(0, 0, 1e-3f), {2, 0, 0}, {0, 2, 0}, m);
  add_quad(world, {0.0f, -1.0f, -1.0f}, {0, 2, 0}, {0, 0, 2}, m);
  const RayScene scene = test::build(world);
  for (std::uint32_t i = 0; i < world.triangles.size(); ++i)
    EXPECT_FALSE(scene.is_coplanar({i, 1.0f, 0.3f, 0.3f})) << i;
}

TEST(Coplanar, AnEdgeThatIsSharedIsNoOverlap) {
  World world;
  test::add_sphere(world, {0, 0, 0}, 1.0f, 8, both_sides(AlphaMode::opaque));
  add_quad(world, {-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, both_sides(AlphaMode::opaque));
  const RayScene scene = test::build(world);
  for (std::uint32_t i = 0; i < world.triangles.size(); ++i)
    EXPECT_FALSE(scene.is_coplanar({i, 1.0f, 0.3f, 0.3f})) << i;
}

}  // namespace
}  // namespace asos::coplanar_test
