#include "renderer/rays/ray_scene.h"
#include "tests/renderer/rays/ray_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace asos::shadow_queries_test {
namespace {

using test::add_square;
using test::blended;
using test::build;
using test::down;
using test::masked;
using test::matte;

const Material grey = matte(glm::vec3(0.5f));

Blocker blocker_of(const RayScene& scene, const Ray& ray, std::int32_t ignored_part = -1) {
  Blocker blocker;
  scene.blockers({&ray, 1}, {&blocker, 1}, ignored_part);
  return blocker;
}

/// Random triangles: opaque, blended and masked (some fully transparent), with several opacities.
World random_kinds(std::uint32_t seed, int count) {
  World world = test::random_triangles(seed, count, 0.4f);
  for (std::size_t i = 0; i < world.materials.size(); ++i) {
    if (i % 4 == 1) world.materials[i] = blended(0.1f * static_cast<float>(i % 9));
    if (i % 4 == 2) world.materials[i] = masked(i % 8 == 2 ? 2.0f : 0.5f);
    if (i % 8 == 3) world.materials[i].transmission = 0.25f;
    if (i % 8 == 4) world.materials[i] = blended(0.3f);
  }
  return world;
}

std::vector<Ray> random_rays(std::uint32_t seed, std::size_t count) {
  std::mt19937 rng(seed);
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) ray = test::random_ray(rng);
  // Some end early, and some cannot be traced.
  for (std::size_t i = 0; i < count; i += 5) rays[i].t_far = 1.5f;
  for (std::size_t i = 3; i < count; i += 50) rays[i].direction = glm::vec3(0.0f);
  return rays;
}

/// Answers both queries for one ray by repeated calls of `closest`.
Blocker stepped(const World& world, const RayScene& scene, Ray ray) {
  Blocker found;
  while (true) {
    const Hit hit = scene.closest(ray);
    if (!hit.valid()) return found;
    const Material& material = world.material_of(hit.triangle);
    const float opacity = test::factor_alpha(world, hit.triangle, hit.b1, hit.b2);
    const bool lets_through =
        material.alpha_mode == AlphaMode::blend || material.transmission > 0.0f;
    if (!lets_through) {
      found.hit = hit;
      found.transmittance = glm::vec3(0.0f);
      return found;
    }
    found.transmittance *= 1.0f - opacity;
    ray.t_near = std::nextafter(hit.t, 100.0f) + 1e-6f;
  }
}

TEST(ShadowQueries, AgreeWithSteppingThroughTheSurfaces) {
  const World world = random_kinds(31, 320);
  RayScene scene = build(world);
  const std::vector<Ray> rays = random_rays(32, 2001);
  int partly = 0;
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<glm::vec3> shares(rays.size(), glm::vec3(-1.0f));
    std::vector<Blocker> met(rays.size());
    scene.transmittance(rays, shares);
    scene.blockers(rays, met);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Blocker expected = stepped(world, scene, rays[i]);
      ASSERT_EQ(met[i].hit.triangle, expected.hit.triangle) << "width " << width << " ray " << i;
      // Factors are multiplied in the order of traversal, which changes rounding.
      EXPECT_NEAR(shares[i].x, expected.transmittance.x, 1e-6f) << width << " " << i;
      EXPECT_NEAR(met[i].transmittance.x, expected.transmittance.x, 1e-6f) << width << " " << i;
      EXPECT_NEAR(scene.transmittance(rays[i]).x, shares[i].x, 1e-6f) << width << " " << i;
      const Blocker alone = blocker_of(scene, rays[i]);
      EXPECT_EQ(alone.hit.triangle, met[i].hit.triangle) << width << " " << i;
      EXPECT_EQ(alone.see_through, met[i].see_through) << width << " " << i;
      partly += shares[i].x > 0.0f && shares[i].x < 1.0f;
    }
  }
  EXPECT_GT(partly, 400);
}

TEST(ShadowQueries, LanesOfAPacketMeetDifferentLayers) {
  // Strips along x: nothing, one layer, two layers, two layers over an opaque one.
  World world;
  test::add_quad(world, {1, -1, 0.0f}, {3, 0, 0}, {0, 2, 0}, blended(0.25f));
  test::add_quad(world, {2, -1, -0.5f}, {2, 0, 0}, {0, 2, 0}, blended(0.5f));
  test::add_quad(world, {3, -1, -1.0f}, {1, 0, 0}, {0, 2, 0}, grey);
  RayScene scene = build(world);
  const float left[] = {1.0f, 0.75f, 0.375f, 0.0f};
  std::vector<Ray> rays;
  for (int i = 0; i < 37; ++i) rays.push_back(down(static_cast<float>(i % 4) + 0.4f, 0.3f));
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<glm::vec3> shares(rays.size());
    std::vector<Blocker> met(rays.size());
    scene.transmittance(rays, shares);
    scene.blockers(rays, met);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_FLOAT_EQ(shares[i].x, left[i % 4]) << width << " " << i;
      EXPECT_FLOAT_EQ(met[i].transmittance.x, left[i % 4]) << width << " " << i;
      EXPECT_EQ(met[i].hit.valid(), i % 4 == 3) << width << " " << i;
      EXPECT_EQ(met[i].see_through, i % 4 != 0) << width << " " << i;
    }
  }
}

TEST(ShadowQueries, BlockersOfOpaqueScenesAreTheClosestHits) {
  const World world = test::random_triangles(41, 300, 0.3f);
  RayScene scene = build(world);
  const std::vector<Ray> rays = random_rays(42, 500);
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<Hit> hits(rays.size());
    std::vector<Blocker> met(rays.size());
    scene.closest(rays, hits);
    scene.blockers(rays, met);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(met[i].hit.triangle, hits[i].triangle);
      EXPECT_EQ(met[i].hit.t, hits[i].t);
      EXPECT_EQ(met[i].transmittance.x, hits[i].valid() ? 0.0f : 1.0f);
      EXPECT_FALSE(met[i].see_through);
    }
  }
}

TEST(ShadowQueries, WhatLiesBehindTheBlockerIsNotTouched) {
  for (const bool layer_in_front : {false, true}) {
    for (const Material& layer : {blended(0.5f), masked(2.0f)}) {
      World world;
      add_square(world, 0.0f, grey);
      add_square(world, layer_in_front ? 0.5f : -0.5f, layer);
      const RayScene scene = build(world);
      const Blocker met = blocker_of(scene, down(0.1f, 0.3f));
      EXPECT_FLOAT_EQ(met.hit.t, 1.0f);
      EXPECT_EQ(met.transmittance.x, 0.0f);
      EXPECT_EQ(met.see_through, layer_in_front);
    }
  }
}

TEST(ShadowQueries, HolesLetAllLightThroughAndAreTouched) {
  World world;
  add_square(world, 0.0f, masked(2.0f));
  const RayScene scene = build(world);
  const Blocker through_hole = blocker_of(scene, down(0.1f, 0.3f));
  EXPECT_FALSE(through_hole.hit.valid());
  EXPECT_EQ(through_hole.transmittance.x, 1.0f);
  EXPECT_TRUE(through_hole.see_through);
  EXPECT_FALSE(blocker_of(scene, down(3.0f, 0.3f)).see_through);  // beside the hole
  Ray above = down(0.1f, 0.3f);
  above.t_far = 0.9f;
  EXPECT_FALSE(blocker_of(scene, above).see_through);
}

TEST(ShadowQueries, AMaskedBlockerIsTouchedItself) {
  World world;
  add_square(world, 0.0f, masked(0.5f));
  const RayScene scene = build(world);
  const Blocker met = blocker_of(scene, down(0.1f, 0.3f));
  EXPECT_FLOAT_EQ(met.hit.t, 1.0f);
  EXPECT_TRUE(met.see_through);
}

TEST(ShadowQueries, ManyLayersLeaveNothing) {
  World world;
  for (int i = 0; i < 40; ++i) add_square(world, -0.01f * static_cast<float>(i), blended(0.5f));
  const RayScene scene = build(world);
  const Ray ray = down(0.1f, 0.3f);
  EXPECT_EQ(scene.transmittance(ray).x, 0.0f);
  const Blocker met = blocker_of(scene, ray);
  EXPECT_EQ(met.transmittance.x, 0.0f);
  EXPECT_FALSE(met.hit.valid());
}

TEST(ShadowQueries, UntraceableRaysAndUnbuiltScenesLetAllLightThrough) {
  World world;
  add_square(world, 0.0f, blended(0.5f));
  add_square(world, -1.0f, grey);
  const RayScene built = build(world);
  const RayScene unbuilt;
  std::vector<Ray> rays(20, down(0.1f, 0.3f));
  for (std::size_t i = 0; i < rays.size(); i += 2) {
    rays[i].direction = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  }
  std::vector<glm::vec3> shares(rays.size(), glm::vec3(-1.0f));
  std::vector<Blocker> met(rays.size(), Blocker{{1, 2, 3, 4}, glm::vec3(-1.0f), true});
  built.transmittance(rays, shares);
  built.blockers(rays, met);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(shares[i].x, i % 2 ? 0.0f : 1.0f) << i;
    EXPECT_EQ(met[i].transmittance.x, i % 2 ? 0.0f : 1.0f) << i;
    EXPECT_EQ(met[i].hit.valid(), i % 2 == 1) << i;
    EXPECT_EQ(met[i].see_through, i % 2 == 1) << i;
  }
  unbuilt.transmittance(rays, shares);
  unbuilt.blockers(rays, met);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(shares[i].x, 1.0f);
    EXPECT_FALSE(met[i].hit.valid() || met[i].see_through);
    EXPECT_EQ(met[i].transmittance.x, 1.0f);
  }
}

}  // namespace
}  // namespace asos::shadow_queries_test
