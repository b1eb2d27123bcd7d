#include "renderer/world/shared_meshes.h"
#include "tests/renderer/rays/ray_worlds.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

// Rays at any time of a motion through several worlds.

namespace asos::test {
namespace {

/// A triangle at z = 0 whose corner is at (x, 0), with legs of length 1.
World triangle_at(float x, bool double_sided = true) {
  World world;
  Material material = matte(glm::vec3(0.5f));
  material.double_sided = double_sided;
  add_triangle(world, {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, material);
  return world;
}

RenderFeatures culled() {
  RenderFeatures features;
  features.culling = true;
  return features;
}

RayScene moving(const std::vector<World>& worlds) {
  std::vector<const World*> poses;
  for (const World& world : worlds) poses.push_back(&world);
  auto built = RayScene::build_moving(poses, factor_alpha, {}, culled());
  EXPECT_TRUE(built.has_value());
  return std::move(*built);
}

Hit hit_at(const RayScene& rays, const World& pose, const Ray& ray, float time,
           Culling faces = Culling::none) {
  Hit hit;
  rays.closest(std::span(&ray, 1), std::span(&time, 1), pose, std::span(&hit, 1), faces);
  return hit;
}

TEST(MovingRays, MeetTrianglesAtTheirOwnTime) {
  const std::vector<World> worlds{triangle_at(0), triangle_at(4), triangle_at(6)};
  const RayScene rays = moving(worlds);
  // The corner is at 8 t until t = 1/2, and at 4 + 4 (t - 1/2) after.
  for (const float time : {0.0f, 0.2f, 0.5f, 0.7f, 1.0f}) {
    const float corner = time < 0.5f ? 8.0f * time : 4.0f + 4.0f * (time - 0.5f);
    EXPECT_FALSE(hit_at(rays, worlds[0], down(corner - 0.02f, 0.1f), time).valid()) << time;
    const Hit hit = hit_at(rays, worlds[0], down(corner + 0.25f, 0.125f), time);
    ASSERT_TRUE(hit.valid()) << time;
    EXPECT_NEAR(hit.b1, 0.25f, 1e-5f);
    EXPECT_NEAR(hit.b2, 0.125f, 1e-5f);
  }
}

TEST(MovingRays, OfOneQueryHaveTimesOfTheirOwn) {
  const std::vector<World> worlds{triangle_at(0), triangle_at(16)};
  const RayScene rays = moving(worlds);
  std::vector<Ray> all;
  std::vector<float> times;
  for (int i = 0; i < 37; ++i) {
    times.push_back(static_cast<float>(i % 7) / 8.0f);
    all.push_back(down(16.0f * times.back() + 0.25f + (i % 2 ? 1.0f : 0.0f), 0.25f));
  }
  std::vector<Hit> hits(all.size());
  rays.closest(all, times, worlds[0], hits);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_EQ(hits[i].valid(), i % 2 == 0) << i;
}

TEST(MovingRays, PassBacksAtTheirOwnTime) {
  // The front faces up at first; half a turn later, down.
  std::vector<World> worlds{triangle_at(0, false), triangle_at(0, false)};
  std::swap(worlds[1].positions[1], worlds[1].positions[2]);
  const RayScene rays = moving(worlds);
  const Ray ray = down(0.3f, 0.3f);
  const auto meets = [&](std::size_t pose) {
    const auto time = static_cast<float>(pose);
    return hit_at(rays, worlds[pose], ray, time, Culling::as_material_says).valid();
  };
  EXPECT_TRUE(meets(0));
  EXPECT_FALSE(meets(1));
}

TEST(MovingRays, MeetFacesAtTheirOwnTime) {
  const auto ball = [](double x) {
    World world;
    add_triangle(world, {90, 90, 0}, {91, 90, 0}, {90, 91, 0}, matte(glm::vec3(0.5f)));
    Shape sphere;
    const auto faces = place_shape(sphere, glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0, 0)));
    for (const ShapeFace& face : faces) {
      world.faces.push_back(face);
      world.triangle_part.push_back(0);
    }
    world.bounds.grow(glm::vec3(-2.0f));
    world.bounds.grow(glm::vec3(20.0f));
    return world;
  };
  const std::vector<World> worlds{ball(0), ball(8)};
  const RayScene rays = moving(worlds);
  for (const float time : {0.0f, 0.25f, 0.6f, 1.0f}) {
    const Hit hit = hit_at(rays, worlds[0], down(8.0f * time, 0.0f, 5.0f), time);
    ASSERT_TRUE(hit.valid()) << time;
    EXPECT_TRUE(worlds[0].is_face(hit.triangle));
    const glm::dvec3 p = face_point(worlds[0].face(hit.triangle), hit.b1, hit.b2).position;
    EXPECT_NEAR(p.x, 0.0, 1e-5) << "the same point of the ball, where it begins";
    EXPECT_FALSE(hit_at(rays, worlds[0], down(8.0f * time + 2.5f, 0.0f, 5.0f), time).valid());
  }
}

/// Many triangles. The first one moves.
World mostly_still(float x) {
  World world = random_triangles(3, 4000, 0.05f);
  for (const std::uint32_t corner : {0u, 1u, 2u}) world.positions[corner].x += x;
  return world;
}

TEST(MovingRays, StoreOnceWhatStandsStill) {
  std::vector<World> worlds;
  for (int i = 0; i <= 32; ++i) worlds.push_back(mostly_still(0.1f * static_cast<float>(i)));
  const std::size_t one = build(worlds[0]).memory_bytes();
  EXPECT_LT(static_cast<double>(moving(worlds).memory_bytes()), 1.25 * static_cast<double>(one));
}

}  // namespace
}  // namespace asos::test
