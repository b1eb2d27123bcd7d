#include "renderer/world/world.h"

#include "renderer/world/render_features.h"
#include "tests/support/flat_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

Mesh triangle_mesh() {
  Mesh mesh{.name = "triangle", .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  mesh.normals.assign(3, glm::vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Scene scene_of(Mesh mesh, const glm::dmat4& placed = glm::dmat4(1.0)) {
  Scene scene{.source = "test"};
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({"it", 0, placed});
  return scene;
}

TEST(Flatten, RecentresInDoublePrecision) {
  // At ten million units, floats cannot resolve steps of half a unit.
  const glm::dvec3 far(1e7, -2e7, 3e7);
  Mesh mesh = triangle_mesh();
  mesh.positions[1] = {0.25f, 0, 0};
  const Result<World> world =
      test::flat_world(scene_of(mesh, glm::translate(glm::dmat4(1.0), far)));
  ASSERT_TRUE(world);
  const glm::dvec3 p = world->origin + glm::dvec3(world->positions[1]);
  EXPECT_NEAR(p.x, 1e7 + 0.25, 1e-6);
  EXPECT_EQ(world->bounds.lo, -world->bounds.hi);
}

TEST(Flatten, LightsAndCamerasMoveAlong) {
  Scene scene = scene_of(triangle_mesh(), glm::translate(glm::dmat4(1.0), glm::dvec3(100, 0, 0)));
  scene.lights.emplace_back();
  scene.lights[0].position = {100, 5, 0};
  scene.lights[0].outlines = {{{100, 5, 0}, {101, 5, 0}, {100, 5, 0.1}}};
  scene.cameras.emplace_back();
  scene.cameras[0].world_from_camera[3] = {100, 0, 7, 1};
  const Result<FlattenedScene> flattened = flatten(scene);
  ASSERT_TRUE(flattened);
  const auto& [world, lights] = *flattened;
  EXPECT_EQ(lights[0].position + world.origin, glm::dvec3(100, 5, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(lights[0].outlines[0][i], scene.lights[0].outlines[0][i] - world.origin);
  }
  EXPECT_EQ(glm::dvec3(world.cameras[0].world_from_camera[3]) + world.origin,
            glm::dvec3(100, 0, 7));
  EXPECT_EQ(world.cameras[0].world_from_camera[3].w, 1.0);
}

TEST(Flatten, PartsKnowWhatShowsALight) {
  Scene scene = scene_of(triangle_mesh(), glm::dmat4(1.0));
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].shows_light = true;
  const Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  EXPECT_FALSE(world->parts.at(0).shows_light);
  EXPECT_TRUE(world->parts.at(1).shows_light);
}

TEST(Flatten, MirrorsTurnTrianglesAndTangentsRound) {
  Scene scene = scene_of(triangle_mesh(), glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)));
  scene.images.push_back({"i", 1, 1, {0, 0, 0, 255}});
  scene.textures.emplace_back();
  scene.textures[0].image = 0;
  scene.materials.emplace_back();
  scene.materials[0].normal_texture.texture = 0;
  scene.meshes[0].material = 0;
  scene.meshes[0].tangents.assign(3, glm::vec4(1, 0, 0, 1));
  const Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  const glm::uvec3 t = world->triangles[0];
  const glm::vec3 a = world->positions[t.x];
  EXPECT_GT(glm::cross(world->positions[t.y] - a, world->positions[t.z] - a).z, 0.0f);
  EXPECT_EQ(world->tangents[0], glm::vec4(-1, 0, 0, -1));
  // The bitangent was +Y and still is.
  const glm::vec3 bitangent =
      glm::cross(world->normals[0], glm::vec3(world->tangents[0])) * world->tangents[0].w;
  EXPECT_EQ(bitangent, glm::vec3(0, 1, 0));
}

TEST(Flatten, InventsNoTangentsForMeshesWithoutThem) {
  Scene scene = scene_of(triangle_mesh());
  scene.images.push_back({"i", 1, 1, {0, 0, 0, 255}});
  scene.textures.emplace_back();
  scene.textures[0].image = 0;
  scene.materials.emplace_back();
  scene.materials[0].normal_texture.texture = 0;
  scene.meshes[0].material = 0;
  scene.meshes.push_back(scene.meshes[0]);
  scene.meshes[1].tangents.assign(3, glm::vec4(1, 0, 0, -1));
  scene.instances.push_back({"second", 1, glm::dmat4(1.0)});
  const Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  ASSERT_EQ(world->tangents.size(), 6u);
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(world->tangents[v], glm::vec4(0.0f)) << "the texture's direction must be used";
    EXPECT_EQ(world->tangents[3 + v], glm::vec4(1, 0, 0, -1));
  }
}

TEST(Flatten, KeepsOnlyAttributesThatMaterialsNeed) {
  Scene scene = scene_of(triangle_mesh());
  scene.meshes[0].texcoords[0].assign(3, glm::vec2(0.5f));
  scene.meshes[0].tangents.assign(3, glm::vec4(1, 0, 0, 1));
  scene.meshes[0].colors.assign(3, glm::vec4(1));
  const Result<World> bare = test::flat_world(scene);
  ASSERT_TRUE(bare);
  EXPECT_TRUE(bare->texcoords[0].empty());
  EXPECT_TRUE(bare->tangents.empty());
  EXPECT_TRUE(bare->colors.empty()) << "all white";
  scene.meshes[0].colors[1] = glm::vec4(1, 0, 0, 1);
  const Result<World> red = test::flat_world(scene);
  ASSERT_TRUE(red);
  EXPECT_EQ(red->colors.size(), 3u);
  EXPECT_TRUE(find_render_features(*red).vertex_colors);
  EXPECT_FALSE(find_render_features(*bare).vertex_colors);
}

TEST(Flatten, MeshesWithoutNormalsAreFlat) {
  Mesh mesh = triangle_mesh();
  mesh.normals.clear();
  mesh.positions.push_back({0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 1, 1}};
  const Result<World> world = test::flat_world(scene_of(mesh));
  ASSERT_TRUE(world);
  ASSERT_EQ(world->triangles.size(), 3u) << "a triangle without area is kept";
  EXPECT_EQ(world->normals[world->triangles[0].x], glm::vec3(0, 0, 1));
  EXPECT_EQ(world->normals[world->triangles[1].x], glm::vec3(1, 0, 0));
  for (const glm::vec3 n : world->normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
}

TEST(Flatten, PartsDescribeInstances) {
  Scene scene = scene_of(triangle_mesh());
  scene.instances.push_back({"", 0, glm::dmat4(1.0)});
  const Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  ASSERT_EQ(world->parts.size(), 2u);
  EXPECT_EQ(world->parts[0].name, "it");
  EXPECT_EQ(world->parts[1].name, "triangle");
  EXPECT_EQ(world->parts[1].first_triangle, 1u);
  EXPECT_EQ(world->parts[1].first_vertex, 3u);
  EXPECT_EQ(world->triangles[1], glm::uvec3(3, 4, 5));
  EXPECT_EQ(world->material_of(1).name, "default");
}

TEST(Flatten, RefusesWhatDoesNotFit) {
  Scene scene = scene_of(triangle_mesh());
  scene.instances.push_back(scene.instances[0]);
  EXPECT_FALSE(flatten(scene, 1));
  EXPECT_TRUE(flatten(scene, 2));
  EXPECT_FALSE(flatten(scene_of(triangle_mesh(), glm::scale(glm::dmat4(1), glm::dvec3(1e30)))));
  glm::dmat4 infinite(1.0);
  infinite[3][0] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(flatten(scene_of(triangle_mesh(), infinite)));
  Scene broken = scene_of(triangle_mesh());
  broken.meshes[0].triangles[0].x = 3;
  EXPECT_FALSE(flatten(broken));
  broken = scene_of(triangle_mesh());
  broken.instances[0].mesh = 1;
  EXPECT_FALSE(flatten(broken));
}

TEST(DefaultCamera, FramesScenesOfAnySizeAndShape) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    for (const glm::dvec3 shape :
         {glm::dvec3(1, 1, 1), glm::dvec3(1, 0, 1), glm::dvec3(0, 3, 0), glm::dvec3(0, 0, 0)}) {
      for (const double aspect : {0.2, 1.0, 4.0}) {
        World world;
        world.bounds.grow(glm::vec3(-0.5 * size * shape));
        world.bounds.grow(glm::vec3(0.5 * size * shape));
        const Camera camera = default_camera(world, aspect);
        const glm::dmat4 to_camera = glm::inverse(camera.world_from_camera);
        const double tan_y = std::tan(0.5 * camera.fov_y_rad);
        double widest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
          const glm::dvec3 p(corner & 1 ? world.bounds.hi.x : world.bounds.lo.x,
                             corner & 2 ? world.bounds.hi.y : world.bounds.lo.y,
                             corner & 4 ? world.bounds.hi.z : world.bounds.lo.z);
          const glm::dvec3 q(to_camera * glm::dvec4(p, 1.0));
          ASSERT_LT(q.z, 0.0) << "behind the camera";
          widest = std::max(
              {widest, std::abs(q.x) / (-q.z * tan_y * aspect), std::abs(q.y) / (-q.z * tan_y)});
        }
        EXPECT_LT(widest, 1.0);
        if (shape != glm::dvec3(0)) {
          EXPECT_GT(widest, 0.5) << "the scene is too small in the picture";
        }
        EXPECT_GT(camera.world_from_camera[2].y, 0.0) << "seen from above";
      }
    }
  }
  const Camera empty = default_camera(World{}, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(std::isfinite(empty.world_from_camera[3].z));
}

}  // namespace
}  // namespace asos
