#include "renderer/rays/ray_scene.h"

#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/tiny_world.h"
#include "tests/support/triangle_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace asos::ray_scene_test {
namespace {

using test::add_quad;
using test::add_triangle;
using test::build;
using test::matte;
using test::random_ray;
using test::random_triangles;

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Reference implementation: tests every triangle, in double.
struct Oracle {
  std::uint32_t triangle = Hit::none;
  double t = infinity;
  double margin = 1.0;  ///< smallest absolute barycentric coordinate of any candidate
};

Oracle brute_force(const World& world, const Ray& ray) {
  Oracle best;
  for (std::uint32_t i = 0; i < world.triangles.size(); ++i) {
    const auto met = test::crossing(world, i, glm::dvec3(ray.origin), glm::dvec3(ray.direction));
    if (!met || met->t < ray.t_near || met->t > ray.t_far) continue;
    best.margin = std::min(best.margin, std::abs(met->inside()));
    if (met->inside() >= 0.0 && met->t < best.t) {
      best.triangle = i;
      best.t = met->t;
    }
  }
  return best;
}

TEST(RayScene, AgreesWithBruteForceInDouble) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const World world = random_triangles(seed, 200, 0.4f);
    const RayScene scene = build(world);
    std::mt19937 rng(seed + 100);
    std::vector<Ray> rays(1003);  // not a multiple of any packet width
    for (Ray& ray : rays) ray = random_ray(rng);
    std::vector<Hit> packet_hits(rays.size());
    scene.closest(rays, packet_hits);

    int compared = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Oracle expected = brute_force(world, rays[i]);
      if (expected.margin < 1e-4) continue;  // near an edge floats may give either result
      ++compared;
      for (const Hit& hit : {scene.closest(rays[i]), packet_hits[i]}) {
        ASSERT_EQ(hit.triangle, expected.triangle) << "seed " << seed << " ray " << i;
        if (!hit.valid()) continue;
        // Triangles and distances are about 1 here.
        EXPECT_NEAR(hit.t, expected.t, 2e-4 * (1.0 + expected.t)) << "seed " << seed << " " << i;
      }
      EXPECT_EQ(scene.transmittance(rays[i]).x, expected.triangle == Hit::none ? 1.0f : 0.0f);
    }
    EXPECT_GT(compared, 900);
  }
}

// A hierarchy for one time of an animation gives the same answers.
TEST(RayScene, OfAMomentAnswersTheSame) {
  const World world = random_triangles(4, 5000, 0.1f);
  const RayScene lasting = build(world);
  const RayScene moment = build(world, test::factor_alpha, {}, BvhPurpose::moment);
  std::mt19937 rng(104);
  std::vector<Ray> rays(4003);
  for (Ray& ray : rays) ray = random_ray(rng);
  std::vector<Hit> hits(rays.size()), hits_of_moment(rays.size());
  lasting.closest(rays, hits);
  moment.closest(rays, hits_of_moment);
  int met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits_of_moment[i].triangle, hits[i].triangle) << i;
    EXPECT_EQ(hits_of_moment[i].t, hits[i].t) << i;
    EXPECT_EQ(moment.transmittance(rays[i]), lasting.transmittance(rays[i])) << i;
    met += hits[i].valid();
  }
  EXPECT_GT(met, 500);
}

TEST(RayScene, BarycentricCoordinatesBelongToTheSecondAndThirdCorner) {
  World world;
  add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte(glm::vec3(1)));
  const RayScene scene = build(world);
  Ray ray{.origin = {0.2f, 0.3f, 5}};
  const Hit hit = scene.closest(ray);
  ASSERT_TRUE(hit.valid());
  EXPECT_NEAR(hit.b1, 0.2f, 1e-6f);
  EXPECT_NEAR(hit.b2, 0.3f, 1e-6f);
  EXPECT_FLOAT_EQ(hit.t, 5.0f);
}

TEST(RayScene, EveryPacketWidthFindsTheSame) {
  const World world = random_triangles(7, 300, 0.3f);
  RayScene scene = build(world);
  std::mt19937 rng(8);
  std::vector<Ray> rays(77);
  for (Ray& ray : rays) ray = random_ray(rng);
  std::vector<Hit> reference(rays.size());
  const int widest = scene.packet_width();
  scene.set_packet_width(1);
  ASSERT_EQ(scene.packet_width(), 1);
  scene.closest(rays, reference);
  for (const int width : {4, 8, 16}) {
    scene.set_packet_width(width);
    // Widths that the processor lacks are ignored.
    EXPECT_EQ(scene.packet_width(), std::min(width, widest));
    std::vector<Hit> hits(rays.size());
    scene.closest(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits[i].triangle, reference[i].triangle) << "width " << width << " ray " << i;
    }
  }
}

TEST(RayScene, HitsBothSides) {
  World world;
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, matte(glm::vec3(1)));
  const RayScene scene = build(world);
  for (const float side : {1.0f, -1.0f}) {
    const Ray ray{.origin = {0.1f, 0.2f, side}, .direction = {0, 0, -side}};
    EXPECT_TRUE(scene.closest(ray).valid()) << side;
    EXPECT_EQ(scene.transmittance(ray).x, 0.0f) << side;
  }
}

TEST(RayScene, NoRaySlipsThroughASharedEdge) {
  // Rays straight at the diagonal and at the rows of vertices of a fine grid.
  World world;
  constexpr int n = 16;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const float s = 0.1f;
      add_quad(world, {s * static_cast<float>(x), s * static_cast<float>(y), 0}, {s, 0, 0},
               {0, s, 0}, matte(glm::vec3(1)));
    }
  }
  const RayScene scene = build(world);
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> d(0.01f, 1.59f);
  for (int i = 0; i < 2000; ++i) {
    const float x = d(rng);
    const glm::vec3 target = i % 2 ? glm::vec3(x, x, 0) : glm::vec3(0.1f * 7, x, 0);
    Ray ray{.origin = {0.3f, -2.0f, 5.0f}};
    ray.direction = target - ray.origin;
    EXPECT_TRUE(scene.closest(ray).valid()) << i << " " << x;
    EXPECT_EQ(scene.transmittance(ray).x, 0.0f) << i << " " << x;
  }
}

TEST(RayScene, EmptyWorldAndUnbuiltSceneLetEverythingPass) {
  const World world;
  const RayScene empty = build(world);
  const RayScene unbuilt;
  std::vector<Ray> rays(20);
  for (const RayScene* scene : {&empty, &unbuilt}) {
    std::vector<Hit> hits(rays.size(), Hit{1, 2, 3, 4});
    scene->closest(rays, hits);
    for (const Hit& hit : hits) EXPECT_FALSE(hit.valid());
    EXPECT_FALSE(scene->closest(rays[0]).valid());
    EXPECT_EQ(scene->transmittance(rays[0]).x, 1.0f);
  }
  EXPECT_EQ(unbuilt.memory_bytes(), 0u);
}

TEST(RayScene, ZeroAreaTrianglesAreMissed) {
  World world;
  add_triangle(world, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, matte(glm::vec3(1)));
  add_triangle(world, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, matte(glm::vec3(1)));
  add_quad(world, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, matte(glm::vec3(1)));
  const RayScene scene = build(world);
  Ray ray{.origin = {0, 0, 5}};
  const Hit hit = scene.closest(ray);
  ASSERT_TRUE(hit.valid());
  EXPECT_GE(hit.triangle, 2u);
}

TEST(RayScene, RaysThatAreNotFiniteMeetNothing) {
  World world;
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, matte(glm::vec3(1)));
  const RayScene scene = build(world);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Ray> rays(6);
  for (Ray& ray : rays) ray.origin = {0, 0, 1};
  rays[0].origin.x = nan;
  rays[1].direction = {0, 0, -infinity};
  rays[2].direction = {0, 0, 0};
  rays[3].t_far = nan;
  rays[4].origin.y = infinity;
  std::vector<Hit> hits(rays.size());
  scene.closest(rays, hits);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_FALSE(hits[i].valid()) << i;
    EXPECT_FALSE(scene.closest(rays[i]).valid()) << i;
    EXPECT_EQ(scene.transmittance(rays[i]).x, 1.0f) << i;
  }
  EXPECT_TRUE(hits[5].valid());
}

TEST(RayScene, RespectsTheRaysEnds) {
  World world;
  for (const float z : {0.0f, -1.0f, -2.0f}) {
    add_quad(world, {-1, -1, z}, {2, 0, 0}, {0, 2, 0}, matte(glm::vec3(1)));
  }
  const RayScene scene = build(world);
  Ray ray{.origin = {0.1f, 0.2f, 1}, .t_near = 1.5f};
  EXPECT_FLOAT_EQ(scene.closest(ray).t, 2.0f);
  ray.t_far = 1.9f;
  EXPECT_FALSE(scene.closest(ray).valid());
  EXPECT_EQ(scene.transmittance(ray).x, 1.0f);
}

// Masked: the left half (b1 < 0.5 along u) is transparent. Mixed with opaque parts, so that
// Embree's primitive numbers differ from World's.
float half_alpha(const World&, std::uint32_t, float b1, float) {
  return b1 < 0.5f ? 0.2f : 0.8f;
}

TEST(RayScene, MaskedSurfacesAreCutAtTheirCutoff) {
  World world;
  add_quad(world, {-9, -9, 9}, {1, 0, 0}, {0, 1, 0}, matte(glm::vec3(1)));
  Material masked = matte(glm::vec3(1));
  masked.alpha_mode = AlphaMode::mask;
  masked.alpha_cutoff = 0.5f;
  add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, masked);
  const RayScene scene = build(world, half_alpha);
  const auto toward = [](float x) {
    Ray ray{.origin = {x, 0.1f, 1}};
    return ray;
  };
  EXPECT_FALSE(scene.closest(toward(0.3f)).valid());
  EXPECT_EQ(scene.transmittance(toward(0.3f)).x, 1.0f);
  const Hit hit = scene.closest(toward(0.7f));
  EXPECT_EQ(hit.triangle, 2u);
  EXPECT_EQ(scene.transmittance(toward(0.7f)).x, 0.0f);

  // The same in packets: every second ray passes.
  std::vector<Ray> rays;
  for (int i = 0; i < 40; ++i) rays.push_back(toward(i % 2 ? 0.7f : 0.3f));
  std::vector<Hit> hits(rays.size());
  scene.closest(rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(hits[i].valid(), i % 2 == 1) << i;
}

TEST(RayScene, BlendedSurfacesAreMetAndAttenuate) {
  World world;
  Material blended = matte(glm::vec3(1));
  blended.alpha_mode = AlphaMode::blend;
  blended.base_color.a = 0.25f;
  for (const float z : {0.0f, -1.0f, -2.0f}) {
    add_quad(world, {-1, -1, z}, {2, 0, 0}, {0, 2, 0}, blended);
  }
  Material glass = matte(glm::vec3(1));
  glass.transmission = 0.5f;
  add_quad(world, {-1, -1, -3}, {2, 0, 0}, {0, 2, 0}, glass);
  add_quad(world, {-1, -1, -4}, {0.5f, 0, 0}, {0, 2, 0}, matte(glm::vec3(1)));
  const RayScene scene = build(world);
  Ray ray{.origin = {0.1f, 0.2f, 1}};
  EXPECT_FLOAT_EQ(scene.closest(ray).t, 1.0f);
  EXPECT_FLOAT_EQ(scene.transmittance(ray).x, 0.75f * 0.75f * 0.75f * 0.5f);
  ray.origin.x = -0.8f;  // over the opaque strip
  EXPECT_EQ(scene.transmittance(ray).x, 0.0f);
  ray.t_far = 1.5f;
  EXPECT_FLOAT_EQ(scene.transmittance(ray).x, 0.75f);
}

TEST(RayScene, CountsItsMemory) {
  const World small = random_triangles(1, 10, 0.1f);
  const World large = random_triangles(1, 5000, 0.1f);
  const std::size_t small_bytes = build(small).memory_bytes();
  const std::size_t large_bytes = build(large).memory_bytes();
  EXPECT_GT(small_bytes, 10u * 3u * 12u);
  EXPECT_GT(large_bytes, small_bytes + 5000u * 48u);
}

TEST(RayScene, SameSpanSameBits) {
  const World world = random_triangles(11, 400, 0.3f);
  const RayScene scene = build(world);
  std::mt19937 rng(12);
  std::vector<Ray> rays(64);
  for (Ray& ray : rays) ray = random_ray(rng);
  std::vector<Hit> first(rays.size());
  std::vector<Hit> second(rays.size());
  scene.closest(rays, first);
  scene.closest(rays, second);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(first[i].triangle, second[i].triangle);
    EXPECT_EQ(first[i].t, second[i].t);
    EXPECT_EQ(first[i].b1, second[i].b1);
  }
}

}  // namespace
}  // namespace asos::ray_scene_test
