#include "renderer/world/origin.h"
#include "renderer/world/world.h"
#include "tests/support/flat_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace asos {
namespace {

Scene scene_of(const std::vector<Mesh>& meshes) {
  Scene scene;
  for (const Mesh& mesh : meshes) {
    Instance instance{.mesh = static_cast<int>(scene.meshes.size())};
    scene.meshes.push_back(mesh);
    scene.instances.push_back(instance);
  }
  return scene;
}

Mesh square(float from, float to, float z) {
  return {.positions = {{from, from, z}, {to, from, z}, {to, to, z}, {from, to, z}},
          .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

TEST(WorldNumbers, TheOriginIsTheMiddleOfAnOrdinaryScene) {
  const Result<World> world = test::flat_world(scene_of({square(0, 100, 0), square(1, 2, 4)}));
  ASSERT_TRUE(world);
  EXPECT_EQ(world->origin, glm::dvec3(50, 50, 2));
}

TEST(WorldNumbers, ASmallPartBesideAHugeOneKeepsItsShape) {
  const Result<World> world = test::flat_world(scene_of({square(0, 1e9f, 0), square(1, 2, 4)}));
  ASSERT_TRUE(world);
  EXPECT_EQ(world->origin, glm::dvec3(1.5, 1.5, 4));
  const Part& small = world->parts[1];
  for (std::uint32_t i = 0; i < small.vertex_count; ++i) {
    const glm::vec3 p = world->positions[small.first_vertex + i];
    EXPECT_EQ(glm::abs(p), glm::vec3(0.5f, 0.5f, 0.0f));
  }
}

TEST(WorldNumbers, TheOriginStaysWhereNoOtherIsMuchBetter) {
  // Two small parts with a large distance between them: one of them loses precision with any
  // origin.
  const PlacedBox one{{0, 0, 0}, {1, 1, 1}};
  const PlacedBox other{{1e9, 0, 0}, {1e9 + 1, 1, 1}};
  const glm::dvec3 middle(5e8, 0.5, 0.5);
  EXPECT_EQ(choose_origin({one, other}, middle), middle);
  EXPECT_EQ(choose_origin({one}, {0.5, 0.5, 0.5}), glm::dvec3(0.5));
}

TEST(WorldNumbers, NormalsThatSayNothingBecomeTheTriangles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  Mesh mesh = square(0, 1, 0);
  mesh.normals = {{0, 0, 0}, {nan, nan, nan}, {0, nan, 1}, {infinite, 0, 0}};
  Scene scene = scene_of({mesh});
  for (const bool mirrored : {false, true}) {
    scene.instances[0].world_from_mesh =
        glm::scale(glm::dmat4(1.0), glm::dvec3(mirrored ? -1 : 1, 1, 1));
    const Result<World> world = test::flat_world(scene);
    ASSERT_TRUE(world);
    for (const glm::vec3& n : world->normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  }
}

TEST(WorldNumbers, SoundNormalsStayBesideThoseThatSayNothing) {
  Mesh mesh = square(0, 1, 0);
  mesh.normals = {{0.6f, 0, 0.8f}, {0, 0, 0}, {0, 0.6f, 0.8f}, {0, 0, -1}};
  const Result<World> world = test::flat_world(scene_of({mesh}));
  ASSERT_TRUE(world);
  EXPECT_EQ(world->normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(world->normals[3], glm::vec3(0, 0, -1));
  EXPECT_NEAR(world->normals[0].x, 0.6f, 1e-6f);
}

}  // namespace
}  // namespace asos
