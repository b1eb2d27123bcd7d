#include "renderer/gltf/load.h"
#include "renderer/scene/tessellate.h"
#include "renderer/world/world.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/flat_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

// Analytic shapes in scenes, in worlds and in files (renderer/gltf/SHAPES.md).

namespace asos {
namespace {

using nlohmann::json;

class ShapesTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

  Result<Scene> import(const test::GltfBuilder& builder) {
    std::ofstream(path("scene.glb"), std::ios::binary) << builder.glb();
    return import_gltf(path("scene.glb"));
  }

  /// A square whose extras define a shape that replaces it.
  static test::GltfBuilder with_extras(json shape) {
    test::GltfBuilder b = test::GltfBuilder::square();
    b.node()["extras"]["asos_shape"] = std::move(shape);
    return b;
  }

 private:
  test::TemporaryFolder folder_;
};

Scene all_shapes() {
  Scene scene;
  Material red{.base_color = {0.8f, 0.1f, 0.1f, 1.0f}};
  scene.materials.push_back(red);
  const auto add = [&](const char* name, const Shape& shape, const glm::dmat4& place) {
    Instance instance{.name = name,
                      .mesh = static_cast<int>(scene.meshes.size()),
                      .world_from_mesh = place,
                      .shape = static_cast<int>(scene.shapes.size())};
    scene.meshes.push_back(tessellated(shape));
    scene.meshes.back().material = 0;
    scene.shapes.push_back(shape);
    scene.instances.push_back(instance);
  };
  Shape shape{.radius = 0.7};
  add("ball", shape, glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.2, 0.3)));
  shape.type = Shape::Type::disk;
  add("disk", shape, glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 2.0, 3.0)));
  shape = Shape();
  shape.type = Shape::Type::box;
  shape.size = {1.0, 2.0, 0.3};
  add("box", shape, glm::rotate(glm::dmat4(1.0), 0.5, glm::dvec3(0, 1, 0)));
  shape = Shape();
  shape.type = Shape::Type::cylinder;
  shape.height = 1.5;
  shape.radius_bottom = 0.4;
  shape.radius_top = 0.0;
  add("cone", shape, glm::dmat4(1.0));
  return scene;
}

int warnings_with(const Scene& scene, const std::string& words) {
  int count = 0;
  for (const std::string& warning : scene.notes.warnings)
    count += warning.find(words) != std::string::npos;
  return count;
}

TEST_F(ShapesTest, SurviveTheWayThroughAFile) {
  for (const char* name : {"shapes.glb", "shapes.gltf"}) {
    const Scene scene = all_shapes();
    ASSERT_TRUE(export_gltf(scene, path(name)));
    const Result<Scene> back = import_gltf(path(name));
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_TRUE(back->notes.warnings.empty());
    EXPECT_TRUE(back->notes.unsupported_extensions.empty());
    ASSERT_EQ(back->instances.size(), scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const Instance &was = scene.instances[i], &is = back->instances[i];
      EXPECT_EQ(is.name, was.name);
      EXPECT_EQ(is.world_from_mesh, was.world_from_mesh);
      ASSERT_GE(is.shape, 0) << was.name;
      EXPECT_EQ(back->shapes.at(is.shape), scene.shapes.at(was.shape)) << was.name;
      EXPECT_EQ(back->meshes.at(is.mesh).positions, scene.meshes.at(was.mesh).positions);
      EXPECT_EQ(back->meshes.at(is.mesh).material, 0);
    }
  }
}

TEST_F(ShapesTest, AreWrittenAsTheProposalSays) {
  ASSERT_TRUE(export_gltf(all_shapes(), path("shapes.gltf")));
  std::ifstream file(path("shapes.gltf"));
  const json root = json::parse(file);
  EXPECT_FALSE(root.contains("extensionsRequired"));
  const json& shapes = root["extensions"]["KHR_implicit_shapes"]["shapes"];
  ASSERT_EQ(shapes.size(), 3u);  // the extension has no disk
  EXPECT_EQ(shapes[0], json::parse(R"({"type": "sphere", "sphere": {"radius": 0.7}})"));
  EXPECT_EQ(shapes[1], json::parse(R"({"type": "box", "box": {"size": [1.0, 2.0, 0.3]}})"));
  EXPECT_EQ(shapes[2], json::parse(R"({"type": "cylinder", "cylinder":
      {"height": 1.5, "radiusBottom": 0.4, "radiusTop": 0.0}})"));
  EXPECT_EQ(root["nodes"][3]["extensions"]["ASOS_implicit_shape"]["shape"], 2);
  EXPECT_EQ(root["nodes"][1]["extras"]["asos_shape"],
            json::parse(R"({"type": "disk", "radius": 0.7})"));
  for (const json& node : root["nodes"]) EXPECT_TRUE(node.contains("mesh"));
}

TEST_F(ShapesTest, TheFallbackMeshIsNotDrawnToo) {
  const Result<World> world = test::flat_world(all_shapes());
  ASSERT_TRUE(world);
  EXPECT_EQ(world->triangles.size(), 12u);  // the box
  EXPECT_EQ(all_shapes().instanced_triangles(), 12u);
  EXPECT_EQ(world->faces.size(), 4u);  // ball, disk, side and bottom of the cone
  EXPECT_EQ(world->triangle_part.size(), 16u);
  EXPECT_EQ(world->surface_count(), 16u);
  for (std::uint32_t i = 12; i < 16; ++i) {
    EXPECT_TRUE(world->is_face(i));
    EXPECT_EQ(world->material_of(i).base_color.r, 0.8f);
  }
}

// 1.5 x 0.5 x 0.25 around (1, 2, 3): the part's box is the ellipsoid's.
TEST_F(ShapesTest, ANonUniformScaleMakesAnEllipsoid) {
  Scene scene = all_shapes();
  scene.instances.resize(1);
  scene.instances[0].world_from_mesh =
      glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(1, 2, 3)), glm::dvec3(3, 1, 0.5) / 1.4);
  const Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  const Box& box = world->parts.at(0).bounds;
  const glm::dvec3 lo = glm::dvec3(box.lo) + world->origin;
  const glm::dvec3 hi = glm::dvec3(box.hi) + world->origin;
  EXPECT_LT(glm::distance(lo, glm::dvec3(-0.5, 1.5, 2.75)), 1e-6);
  EXPECT_LT(glm::distance(hi, glm::dvec3(2.5, 2.5, 3.25)), 1e-6);
}

TEST_F(ShapesTest, FlatAndShiningOnesAreTriangles) {
  Scene scene = all_shapes();
  scene.instances.resize(1);
  scene.instances[0].world_from_mesh = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 0, 1));
  Result<World> world = test::flat_world(scene);
  ASSERT_TRUE(world);
  EXPECT_TRUE(world->faces.empty());
  EXPECT_FALSE(world->triangles.empty());

  scene.instances[0].world_from_mesh = glm::dmat4(1.0);
  scene.materials[0].emissive = glm::vec3(1.0f);
  world = test::flat_world(scene);
  ASSERT_TRUE(world);
  EXPECT_TRUE(world->faces.empty());
  EXPECT_FALSE(world->triangles.empty());
}

TEST_F(ShapesTest, DefaultsAreTheProposals) {
  test::GltfBuilder b = test::GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_implicit_shapes", "ASOS_implicit_shape"};
  b.json["extensions"]["KHR_implicit_shapes"]["shapes"] = json::parse(R"([{"type": "cylinder"}])");
  b.node()["extensions"]["ASOS_implicit_shape"]["shape"] = 0;
  const Result<Scene> scene = import(b);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->shapes.size(), 1u);
  EXPECT_EQ(scene->shapes[0].height, 0.5);
  EXPECT_EQ(scene->shapes[0].radius_bottom, 0.25);
  EXPECT_EQ(scene->shapes[0].radius_top, 0.25);
}

TEST_F(ShapesTest, TheExtensionHoldsWhereTheExtrasDiffer) {
  test::GltfBuilder b = with_extras({{"type", "sphere"}, {"radius", 3.0}});
  b.json["extensionsUsed"] = {"KHR_implicit_shapes", "ASOS_implicit_shape"};
  b.json["extensions"]["KHR_implicit_shapes"]["shapes"] =
      json::parse(R"([{"type": "sphere", "sphere": {"radius": 2.0}}])");
  b.node()["extensions"]["ASOS_implicit_shape"]["shape"] = 0;
  const Result<Scene> scene = import(b);
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->shapes.size(), 1u);
  EXPECT_EQ(scene->shapes[0].radius, 2.0);
  EXPECT_EQ(warnings_with(*scene, "extras"), 1);
}

TEST_F(ShapesTest, ANodeWithoutMeshIsAShapeAllTheSame) {
  test::GltfBuilder b = with_extras({{"type", "sphere"}});
  b.node().erase("mesh");
  const Result<Scene> scene = import(b);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->instances.size(), 1u);
  EXPECT_EQ(scene->instances[0].shape, 0);
  EXPECT_TRUE(scene->notes.warnings.empty());
}

TEST_F(ShapesTest, BadOnesAreNamedAndTheirMeshIsDrawn) {
  const std::vector<std::pair<json, std::string>> bad{
      {json(7), "not an object"},
      {{{"type", "torus"}}, "'torus'"},
      {{{"type", "capsule"}}, "'capsule'"},
      {{{"radius", 1.0}}, "''"},
      {{{"type", "sphere"}, {"radius", 0.0}}, "radius is 0"},
      {{{"type", "sphere"}, {"radius", -1.0}}, "radius is -1"},
      {{{"type", "sphere"}, {"radius", "big"}}, "not a number"},
      {{{"type", "box"}, {"size", {1.0, 2.0}}}, "three numbers"},
      {{{"type", "box"}, {"size", {1.0, 2.0, 0.0}}}, "size is 0"},
      {{{"type", "cylinder"}, {"radiusBottom", 0.0}, {"radiusTop", 0.0}}, "both radii"},
      {{{"type", "cylinder"}, {"height", 0.0}}, "height is 0"}};
  for (const auto& [shape, words] : bad) {
    const Result<Scene> scene = import(with_extras(shape));
    ASSERT_TRUE(scene) << shape;
    EXPECT_TRUE(scene->shapes.empty()) << shape;
    ASSERT_EQ(scene->instances.size(), 1u) << shape;
    EXPECT_EQ(scene->instances[0].shape, -1);
    EXPECT_EQ(warnings_with(*scene, words), 1) << shape;
    EXPECT_EQ(warnings_with(*scene, "node 0"), 1) << shape;
  }
  test::GltfBuilder b = test::GltfBuilder::square();
  b.json["extensionsUsed"] = {"ASOS_implicit_shape"};
  b.node()["extensions"]["ASOS_implicit_shape"]["shape"] = 4;
  const Result<Scene> scene = import(b);
  ASSERT_TRUE(scene);
  EXPECT_EQ(warnings_with(*scene, "does not define"), 1);
}

TEST_F(ShapesTest, ScenesWithBadShapesAreRefused) {
  Scene scene = all_shapes();
  scene.shapes[0].radius = std::nan("");
  EXPECT_FALSE(flatten(scene));
  EXPECT_FALSE(export_gltf(scene, path("bad.glb")));
  scene = all_shapes();
  scene.instances[2].shape = 9;
  EXPECT_FALSE(flatten(scene));
  EXPECT_FALSE(export_gltf(scene, path("bad.glb")));
}

}  // namespace
}  // namespace asos
