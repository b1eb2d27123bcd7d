#include "renderer/rays/ray_scene.h"
#include "tests/renderer/rays/ray_worlds.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace asos::own_part_test {
namespace {

using test::add_square;
using test::blended;
using test::down;
using test::lamp_of;
using test::masked;
using test::matte;

const Material grey = matte(glm::vec3(0.5f));

/// A scene with lights that own these parts.
RayScene build(const World& world, const std::vector<std::int32_t>& own_parts) {
  std::vector<Light> lamps;
  for (const std::int32_t part : own_parts) lamps.push_back(lamp_of(part));
  return test::build(world, test::factor_alpha, lamps);
}

struct Answers {
  std::vector<float> shares;
  std::vector<Blocker> met;
};

/// The answers for one ray: single, and in the odd lanes of packets of each width.
Answers all_forms(RayScene& scene, const Ray& ray, std::int32_t ignored_part) {
  Answers answers;
  answers.shares = {scene.transmittance(ray, ignored_part).x};
  answers.met.resize(1);
  scene.blockers({&ray, 1}, answers.met, ignored_part);
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<Ray> rays(20, down(50, 50));
    for (std::size_t i = 1; i < rays.size(); i += 2) rays[i] = ray;
    std::vector<glm::vec3> shares(rays.size());
    std::vector<Blocker> met(rays.size());
    scene.transmittance(rays, shares, ignored_part);
    scene.blockers(rays, met, ignored_part);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (i % 2 == 0) {
        EXPECT_EQ(shares[i], glm::vec3(1.0f));
        continue;
      }
      answers.shares.push_back(shares[i].x);
      answers.met.push_back(met[i]);
    }
  }
  return answers;
}

TEST(OwnPart, DoesNotShadeItsLight) {
  for (const Material& lamp : {grey, masked(0.5f), blended(0.5f)}) {
    World world;
    add_square(world, 0.0f, lamp);
    RayScene scene = build(world, {0});
    const Answers ignoring = all_forms(scene, down(0.1f, 0.3f), 0);
    for (const float share : ignoring.shares) EXPECT_EQ(share, 1.0f);
    for (const Blocker& met : ignoring.met) {
      EXPECT_FALSE(met.hit.valid());
      EXPECT_EQ(met.transmittance.x, 1.0f);
      EXPECT_FALSE(met.see_through);
    }
    // The part occludes other lights and is visible.
    const float left = lamp.alpha_mode == AlphaMode::blend ? 0.5f : 0.0f;
    const Answers others = all_forms(scene, down(0.1f, 0.3f), -1);
    for (const float share : others.shares) EXPECT_EQ(share, left);
    for (const Blocker& met : others.met) EXPECT_EQ(met.transmittance.x, left);
    EXPECT_TRUE(scene.closest(down(0.1f, 0.3f)).valid());
  }
}

TEST(OwnPart, WhatLiesBehindOrInFrontOfItBlocks) {
  for (const float z : {-0.5f, 0.5f}) {
    World world;
    add_square(world, 0.0f, grey);
    add_square(world, z, grey);
    RayScene scene = build(world, {0});
    const Answers answers = all_forms(scene, down(0.1f, 0.3f), 0);
    for (const float share : answers.shares) EXPECT_EQ(share, 0.0f) << z;
    for (const Blocker& met : answers.met) {
      ASSERT_TRUE(met.hit.valid()) << z;
      EXPECT_EQ(world.triangle_part[met.hit.triangle], 1u) << z;
      EXPECT_FLOAT_EQ(met.hit.t, 1.0f - z);
    }
  }
}

TEST(OwnPart, OfAnotherLightBlocks) {
  World world;
  add_square(world, 0.0f, grey);
  add_square(world, -0.5f, grey);
  add_square(world, -1.0f, grey);
  RayScene scene = build(world, {0, 1, 1});
  const auto blocking_part = [&](std::int32_t ignored_part) {
    const std::vector<Blocker> met = all_forms(scene, down(0.1f, 0.3f), ignored_part).met;
    const std::uint32_t part = world.triangle_part[met[0].hit.triangle];
    for (const Blocker& other : met) EXPECT_EQ(world.triangle_part[other.hit.triangle], part);
    return part;
  };
  EXPECT_EQ(blocking_part(0), 1u);
  EXPECT_EQ(blocking_part(1), 0u);
  EXPECT_EQ(blocking_part(-1), 0u);
  EXPECT_EQ(blocking_part(2), 0u);  // belongs to no light, so it is never ignored
}

TEST(OwnPart, ItsLayersAreLeftOutOfTheProduct) {
  World world;
  add_square(world, 0.0f, blended(0.25f));
  add_square(world, -0.5f, blended(0.5f));
  RayScene scene = build(world, {1});
  const Answers answers = all_forms(scene, down(0.1f, 0.3f), 1);
  for (const float share : answers.shares) EXPECT_FLOAT_EQ(share, 0.75f);
  for (const Blocker& met : answers.met) {
    EXPECT_FLOAT_EQ(met.transmittance.x, 0.75f);
    EXPECT_TRUE(met.see_through);
  }
}

TEST(OwnPart, LampsAreMetAsEverByRaysForTheViewer) {
  const World world = test::random_triangles(51, 200, 0.4f);
  std::vector<std::int32_t> own;
  for (std::int32_t part = 0; part < 200; part += 3) own.push_back(part);
  const RayScene lamps = build(world, own);
  const RayScene plain = test::build(world);
  std::mt19937 rng(52);
  std::vector<Ray> rays(500);
  for (Ray& ray : rays) ray = test::random_ray(rng);
  for (const Culling faces : {Culling::none, Culling::as_material_says}) {
    std::vector<Hit> a(rays.size());
    std::vector<Hit> b(rays.size());
    lamps.closest(rays, a, faces);
    plain.closest(rays, b, faces);
    for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(a[i].triangle, b[i].triangle) << i;
  }
}

TEST(OwnPart, ThatDoesNotExistIsRefused) {
  for (const std::int32_t part : {1, 1000, -2}) {
    World world;
    add_square(world, 0.0f, grey);
    const Light lamp = lamp_of(part);
    const auto built = RayScene::build(world, test::factor_alpha, {&lamp, 1});
    ASSERT_FALSE(built.has_value()) << part;
    EXPECT_NE(built.error().message().find("lamp"), std::string::npos) << part;
    EXPECT_NE(built.error().message().find(std::to_string(part)), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace asos::own_part_test
