#include "renderer/world/placements.h"
#include "renderer/world/shared_meshes.h"
#include "tests/support/instanced_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstddef>

namespace asos::test::mesh_store_test {
namespace {

/// One instance of each of two meshes, the first at `x`.
Scene pose_at(double x) {
  Scene scene = instanced_scene(2, 8, 0.8);
  scene.instances[0].world_from_mesh = glm::translate(glm::dmat4(1.0), {x, 0.0, 0.0});
  return scene;
}

World world_of(const Scene& scene, MeshStore& meshes) {
  auto flat = flatten(scene, most_triangles, glm::dvec3(0.0), meshes);
  EXPECT_TRUE(flat);
  return std::move(flat->world);
}

TEST(MeshStore, IsOneForAllPoses) {
  MeshStore meshes(pose_at(0.0));
  const World first = world_of(pose_at(0.0), meshes);
  const World second = world_of(pose_at(3.0), meshes);
  ASSERT_TRUE(first.placements);
  EXPECT_EQ(first.triangles.own().size(), 2u) << "the floor";
  EXPECT_EQ(first.placements->places.size(), 2u) << "one instance is enough";
  EXPECT_EQ(first.placements->meshes, second.placements->meshes);
  const std::size_t placed = first.positions.own().size();
  EXPECT_NEAR(second.positions[placed].x - first.positions[placed].x, 3.0f, 1e-5f);
  EXPECT_FALSE(meshes.take_dropped());
}

TEST(MeshStore, DropsMeshesThatChange) {
  MeshStore meshes(pose_at(0.0));
  Scene bent = pose_at(1.0);
  bent.meshes[static_cast<std::size_t>(bent.instances[1].mesh)].positions[3].y += 0.1f;
  const World world = world_of(bent, meshes);
  EXPECT_TRUE(meshes.take_dropped());
  EXPECT_FALSE(meshes.take_dropped()) << "it was told once";
  EXPECT_FALSE(meshes.keeps(bent.instances[1].mesh));
  ASSERT_TRUE(world.placements);
  EXPECT_EQ(world.placements->places.size(), 1u);
  EXPECT_FALSE(meshes.empty());
  Scene painted = bent;
  painted.materials.front().roughness = 0.123f;
  (void)world_of(painted, meshes);
  EXPECT_TRUE(meshes.take_dropped()) << "materials matter";
}

}  // namespace
}  // namespace asos::test::mesh_store_test
