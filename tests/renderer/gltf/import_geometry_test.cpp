#include "renderer/gltf/load.h"
#include "renderer/world/world.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/flat_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asos {
namespace {

using test::GltfBuilder;
using test::TemporaryFolder;

Result<Scene> load(const GltfBuilder& builder, const LoadOptions& options = {}) {
  const TemporaryFolder folder;
  return import_gltf(folder.write("test.glb", builder.glb()), options);
}

/// Loads and flattens; stops the test on an error.
World world_of(const GltfBuilder& builder) {
  const Result<Scene> scene = load(builder);
  if (!scene) throw std::runtime_error(scene.error().message());
  Result<World> world = test::flat_world(*scene);
  if (!world) throw std::runtime_error(world.error().message());
  return std::move(*world);
}

glm::dvec3 author(const World& world, glm::vec3 p) {
  return world.origin + glm::dvec3(p);
}

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-6) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// The geometric normal of a triangle according to its winding.
glm::vec3 front(const World& world, std::size_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  const glm::vec3 a = world.positions[t.x];
  return glm::normalize(glm::cross(world.positions[t.y] - a, world.positions[t.z] - a));
}

TEST(ImportGeometry, DrawsEveryMode) {
  // Five points of a convex polygon, such that all modes give triangles that face +Z.
  struct Case {
    int mode;
    std::uint64_t triangles, points, lines;
  };
  for (const Case c : {Case{0, 0, 5, 0}, Case{1, 0, 0, 2}, Case{2, 0, 0, 5}, Case{3, 0, 0, 4},
                       Case{4, 1, 0, 0}, Case{5, 3, 0, 0}, Case{6, 3, 0, 0}}) {
    for (const bool indexed : {false, true}) {
      SCOPED_TRACE(testing::Message() << "mode " << c.mode << ", indexed " << indexed);
      GltfBuilder b;
      std::vector<glm::vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 2, 0}};
      if (c.mode == 5) points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
      auto& primitive = b.primitive({{"POSITION", b.vec3(points)}}, c.mode);
      if (indexed) primitive["indices"] = b.indices({0, 1, 2, 3, 4});
      const Result<Scene> scene = load(b);
      ASSERT_TRUE(scene) << scene.error().message();
      EXPECT_EQ(scene->instanced_triangles(), c.triangles);
      EXPECT_EQ(scene->instanced_points(), c.points);
      EXPECT_EQ(scene->instanced_segments(), c.lines);
      const Result<World> world = test::flat_world(*scene);
      ASSERT_TRUE(world);
      for (std::size_t t = 0; t < world->triangles.size(); ++t) {
        expect_near(front(*world, t), {0, 0, 1});
      }
    }
  }
}

TEST(ImportGeometry, JoinsLinesAsTheirModesSay) {
  using Segments = std::vector<glm::uvec2>;
  for (const auto& [mode, segments] : {std::pair{1, Segments{{3, 0}, {1, 2}}},
                                       std::pair{2, Segments{{3, 0}, {0, 1}, {1, 2}, {2, 3}}},
                                       std::pair{3, Segments{{3, 0}, {0, 1}, {1, 2}}}}) {
    GltfBuilder b;
    const std::vector<glm::vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}};
    const std::vector<glm::vec4> colors{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    b.primitive({{"POSITION", b.vec3(points)}, {"COLOR_0", b.vec4(colors)}}, mode)["indices"] =
        b.indices({3, 0, 1, 2});
    const Result<Scene> scene = load(b);
    ASSERT_TRUE(scene) << scene.error().message();
    ASSERT_EQ(scene->meshes.size(), 1u);
    EXPECT_EQ(scene->meshes[0].segments, segments) << mode;
    EXPECT_EQ(scene->meshes[0].positions, points);
    EXPECT_EQ(scene->meshes[0].colors, colors);
    EXPECT_TRUE(scene->notes.warnings.empty());
  }
}

TEST(ImportGeometry, LeavesOutBrokenLinesAndPoints) {
  const float nan = std::nanf("");
  for (const int mode : {0, 1}) {
    GltfBuilder b;
    const int positions = b.vec3({{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}, {1, 2, 0}});
    b.primitive({{"POSITION", positions}}, mode)["indices"] = b.indices({0, 1, 2, 3, 3, 9, 1});
    const Result<Scene> scene = load(b);
    ASSERT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(scene->instanced_points(), mode == 0 ? 5u : 0u);
    EXPECT_EQ(scene->instanced_segments(), mode == 1 ? 1u : 0u);
    std::string all;
    for (const std::string& warning : scene->notes.warnings) all += warning + "\n";
    EXPECT_NE(all.find(mode == 0 ? "1 of 7 points use vertices that do not exist"
                                 : "1 of 3 line segments use vertices that do not exist"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("not finite"), std::string::npos) << all;
    EXPECT_EQ(all.find("a vertex is left over") != std::string::npos, mode == 1) << all;
  }
}

TEST(ImportGeometry, AppliesSparseReplacementsWithAndWithoutABase) {
  GltfBuilder b = GltfBuilder::square();
  b.bin.clear();
  b.json["accessors"].clear(), b.json["bufferViews"].clear();
  b.json["meshes"][0]["primitives"].clear();
  const int base = b.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int where = b.view(std::vector<std::uint16_t>{2});
  const int what = b.view(std::vector<glm::vec3>{{0, 5, 0}});
  const nlohmann::json sparse = {{"count", 1},
                                 {"indices", {{"bufferView", where}, {"componentType", 5123}}},
                                 {"values", {{"bufferView", what}}}};
  b.json["accessors"][base]["sparse"] = sparse;
  const int zeros = b.accessor(-1, 5126, "VEC3", 3);
  b.json["accessors"][zeros]["sparse"] = sparse;
  b.primitive({{"POSITION", base}});
  b.primitive({{"POSITION", zeros}});
  const World world = world_of(b);
  ASSERT_EQ(world.triangles.size(), 2u);
  expect_near(author(world, world.positions[1]), {1, 0, 0});
  expect_near(author(world, world.positions[2]), {0, 5, 0});
  expect_near(author(world, world.positions[4]), {0, 0, 0});
  expect_near(author(world, world.positions[5]), {0, 5, 0});
}

TEST(ImportGeometry, ReadsInterleavedAndQuantisedAttributes) {
  GltfBuilder b;
  struct Vertex {
    std::int16_t x, y, z, padding;
    std::int8_t n[4];
    std::uint8_t color[4];
  };
  const std::vector<Vertex> vertices{{0, 0, 0, 0, {0, 0, 127, 0}, {255, 0, 0, 255}},
                                     {32767, 0, 0, 0, {0, 0, 127, 0}, {0, 51, 0, 255}},
                                     {0, -32767, 0, 0, {0, 0, 127, 0}, {0, 0, 255, 0}}};
  const int view = b.view(vertices);
  b.json["bufferViews"][view]["byteStride"] = sizeof(Vertex);
  const int p = b.accessor(view, 5122, "VEC3", 3, true);
  const int n = b.accessor(view, 5120, "VEC3", 3, true);
  const int c = b.accessor(view, 5121, "VEC4", 3, true);
  const int raw = b.accessor(view, 5122, "VEC3", 3, false);
  b.json["accessors"][n]["byteOffset"] = 8;
  b.json["accessors"][c]["byteOffset"] = 12;
  b.primitive({{"POSITION", p}, {"NORMAL", n}, {"COLOR_0", c}});
  b.primitive({{"POSITION", raw}});
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const World world = world_of(b);
  expect_near(author(world, world.positions[1]), {1, 0, 0}, 1e-3);
  expect_near(author(world, world.positions[2]), {0, -1, 0}, 1e-3);
  EXPECT_EQ(world.normals[0], glm::vec3(0, 0, 1));
  ASSERT_EQ(world.colors.size(), 6u);
  EXPECT_EQ(world.colors[0], glm::vec4(1, 0, 0, 1));
  EXPECT_FLOAT_EQ(world.colors[1].y, 0.2f);
  EXPECT_EQ(world.colors[4], glm::vec4(1)) << "white where a mesh has no colours";
  expect_near(author(world, world.positions[4]), {32767, 0, 0}, 1e-2);
}

TEST(ImportGeometry, MirroredNodesKeepTheirFrontSides) {
  GltfBuilder b = GltfBuilder::square();
  b.node()["scale"] = {-2.0, 1.0, 1.0};
  const World world = world_of(b);
  expect_near(front(world, 0), {0, 0, 1});
  expect_near(world.normals[0], {0, 0, 1});
  expect_near(author(world, world.positions[1]), {-2, 0, 0});
}

TEST(ImportGeometry, NormalsGoByTheInverseTranspose) {
  // A face at 45 degrees under a stretch: its normal tilts away from the stretched direction.
  GltfBuilder b;
  const int p = b.vec3({{1, 0, 0}, {0, 1, 0}, {1, 0, 1}});
  const int n = b.vec3(std::vector<glm::vec3>(3, glm::normalize(glm::vec3(1, 1, 0))));
  b.primitive({{"POSITION", p}, {"NORMAL", n}});
  b.node()["scale"] = {3.0, 1.0, 1.0};
  const World world = world_of(b);
  expect_near(world.normals[0], glm::normalize(glm::dvec3(1, 3, 0)));
  EXPECT_NEAR(std::abs(glm::dot(front(world, 0), world.normals[0])), 1.0, 1e-6);
}

TEST(ImportGeometry, MissingNormalsAreFlat) {
  GltfBuilder b;
  auto& primitive =
      b.primitive({{"POSITION", b.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})}});
  primitive["indices"] = b.indices({0, 1, 2, 0, 2, 3});
  const World world = world_of(b);
  ASSERT_EQ(world.positions.size(), 6u) << "triangles share no vertices";
  for (std::size_t t = 0; t < 2; ++t) {
    expect_near(world.normals[world.triangles[t].x], front(world, t));
  }
}

TEST(ImportGeometry, OnlyTheVerticesThatAPrimitiveUsesAreKept) {
  GltfBuilder b;
  std::vector<glm::vec3> many(1000, glm::vec3(1e30f));
  many[10] = {0, 0, 0}, many[500] = {1, 0, 0}, many[900] = {0, 1, 0};
  auto& primitive = b.primitive(
      {{"POSITION", b.vec3(many)}, {"NORMAL", b.vec3(std::vector<glm::vec3>(1000, {0, 0, 1}))}});
  primitive["indices"] = b.indices({10, 500, 900});
  const Result<Scene> scene = load(b);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->meshes[0].positions.size(), 3u);
  EXPECT_EQ(scene->meshes[0].positions[1], glm::vec3(1, 0, 0));
  const Result<World> world = test::flat_world(*scene);
  ASSERT_TRUE(world);
  EXPECT_EQ(world->bounds.hi - world->bounds.lo, glm::vec3(1, 1, 0));
}

TEST(ImportGeometry, TangentsFollowTheNormalMap) {
  GltfBuilder b = GltfBuilder::square();
  // u grows along +Y and v along +X, so the texture's up direction (against v) is -X.
  const int uv = b.vec2({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  b.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = uv;
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["images"] = {{{"uri", test::small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"normalTexture", {{"index", 0}, {"scale", 0.5}}}}};
  const World world = world_of(b);
  ASSERT_EQ(world.tangents.size(), 4u);
  EXPECT_FLOAT_EQ(world.materials[0].normal_texture.scale, 0.5f);
  for (std::size_t v = 0; v < 4; ++v) {
    const glm::vec3 t(world.tangents[v]);
    expect_near(t, {0, 1, 0});
    const glm::vec3 up = glm::cross(world.normals[v], t) * world.tangents[v].w;
    expect_near(up, {-1, 0, 0});
  }
  ASSERT_EQ(world.images.size(), 1u);
  EXPECT_EQ(world.images[0].width, 2);
  EXPECT_EQ(world.images[0].rgba[0], 255) << "the first pixel is red";
  EXPECT_EQ(world.images[0].rgba[1], 0);
}

TEST(ImportGeometry, SkinsBendWithTheirJoints) {
  GltfBuilder b = GltfBuilder::square();
  // Vertices 2 and 3 belong to a joint one unit up, which is rotated by 90 degrees about Z.
  const int joints = b.accessor(
      b.view(std::vector<glm::u8vec4>{{0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}}),
      5121, "VEC4", 4);
  const int weights = b.vec4(std::vector<glm::vec4>(4, {1, 0, 0, 0}));
  const glm::mat4 down = glm::translate(glm::mat4(1.0f), glm::vec3(0, -1, 0));
  b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
  b.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;
  const double s = std::sqrt(0.5);
  b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                     {{"children", {2}}},
                     {{"translation", {0, 1, 0}}, {"rotation", {0, 0, s, s}}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", b.mat4({glm::mat4(1.0f), down})}}};
  const World world = world_of(b);
  ASSERT_EQ(world.positions.size(), 4u);
  expect_near(author(world, world.positions[1]), {1, 0, 0}, 1e-6);
  expect_near(author(world, world.positions[2]), {0, 2, 0}, 1e-6);
  expect_near(author(world, world.positions[3]), {0, 1, 0}, 1e-6);
}

TEST(ImportGeometry, MorphsByTheNodesWeightsOrElseTheMeshes) {
  GltfBuilder b = GltfBuilder::square();
  const int delta = b.vec3(std::vector<glm::vec3>(4, {0, 0, 2}));
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", delta}}};
  b.json["meshes"][0]["weights"] = {0.5};
  b.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"weights", {1.0}}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  const World world = world_of(b);
  ASSERT_EQ(world.positions.size(), 8u);
  EXPECT_NEAR(author(world, world.positions[0]).z, 1.0, 1e-6);
  EXPECT_NEAR(author(world, world.positions[4]).z, 2.0, 1e-6);
}

TEST(ImportGeometry, InstancesAreCopiesOfOneMesh) {
  GltfBuilder b = GltfBuilder::square();
  const int at = b.vec3({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}});
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = at;
  b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const Result<Scene> scene = load(b);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->meshes.size(), 1u);
  ASSERT_EQ(scene->instances.size(), 3u);
  EXPECT_EQ(scene->instances[2].world_from_mesh[3], glm::dvec4(20, 0, 0, 1));
  EXPECT_EQ(scene->instanced_triangles(), 6u);
}

TEST(ImportGeometry, ShowsTheSceneThatIsAskedFor) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 9}}});
  b.json["scenes"].push_back({{"nodes", {1, 0}}, {"name", "both"}});
  EXPECT_EQ(load(b)->instances.size(), 1u);
  const Result<Scene> second = load(b, {.scene = "1"});
  ASSERT_TRUE(second);
  EXPECT_EQ(second->instances.size(), 2u);
  EXPECT_EQ(second->name, "both");
  EXPECT_FALSE(load(b, {.scene = "2"}));
}

TEST(ImportGeometry, HidesInvisibleNodesAndCoarserLevelsOfDetail) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_node_visibility", "MSFT_lod"};
  b.json["nodes"] = {
      {{"mesh", 0}, {"extensions", {{"MSFT_lod", {{"ids", {1}}}}}}},
      {{"mesh", 0}},
      {{"children", {3}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
      {{"mesh", 0}}};
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  EXPECT_EQ(load(b)->instances.size(), 1u);
}

TEST(ImportGeometry, PlacesCamerasAndLights) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 5}, {"spot", {{"outerConeAngle", 0.5}}}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
                       {{"type", "orthographic"},
                        {"orthographic", {{"xmag", 4}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 9}}}}};
  const double s = std::sqrt(0.5);
  b.json["nodes"].push_back({{"camera", 0}, {"scale", {2, 2, 2}}, {"rotation", {0, s, 0, s}}});
  b.json["nodes"].push_back({{"camera", 1},
                             {"translation", {1, 2, 3}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2};
  const Result<Scene> scene = load(b);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->cameras.size(), 2u);
  EXPECT_DOUBLE_EQ(scene->cameras[0].fov_y_rad, 0.7);
  expect_near(glm::dvec3(scene->cameras[0].world_from_camera[2]), {1, 0, 0});
  EXPECT_DOUBLE_EQ(scene->cameras[1].height, 4.0);
  EXPECT_DOUBLE_EQ(scene->cameras[1].aspect_ratio.value(), 2.0);
  ASSERT_EQ(scene->lights.size(), 1u);
  expect_near(scene->lights[0].position, {1, 2, 3});
  expect_near(scene->lights[0].direction, {0, 0, -1});
  EXPECT_DOUBLE_EQ(scene->lights[0].outer_cone_rad, 0.5);
}

TEST(ImportGeometry, ALightsExtrasSayWhetherItCastsShadows) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  auto& root = b.json["extensions"]["KHR_lights_punctual"];
  root["lights"] = {
      {{"type", "point"}, {"extras", {{"casts_shadows", false}, {"other", {{"deep", {1, 2}}}}}}},
      {{"type", "point"}, {"extras", {{"casts_shadows", true}}}},
      {{"type", "point"}, {"extras", {{"casts_shadows", "false"}}}},
      {{"type", "point"}, {"extras", {false, "casts_shadows"}}},
      {{"type", "point"}}};
  b.json["scenes"][0]["nodes"] = {0};
  for (int i = 0; i < 5; ++i) {
    b.json["nodes"].push_back(
        {{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}, {"extras", {{"a", i}}}});
    b.json["scenes"][0]["nodes"].push_back(1 + i);
  }
  const Result<Scene> scene = load(b);
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ(scene->lights.size(), 5u);
  EXPECT_FALSE(scene->lights[0].casts_shadows);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_TRUE(scene->lights[i].casts_shadows) << i;
  EXPECT_TRUE(scene->notes.warnings.empty());
}

TEST(ImportGeometry, ReadsMaterials) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_texture_transform",           "KHR_materials_unlit",
                              "KHR_materials_emissive_strength", "KHR_materials_ior",
                              "KHR_materials_transmission",      "ACME_optional"};
  b.json["images"] = {{{"uri", test::small_png}}};
  b.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  b.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  const double quarter = 1.5707963267948966;
  b.json["materials"] = {
      {{"alphaMode", "MASK"},
       {"alphaCutoff", 0.25},
       {"doubleSided", true},
       {"emissiveFactor", {1.0, 0.5, 0.0}},
       {"pbrMetallicRoughness",
        {{"metallicFactor", 0.0},
         {"roughnessFactor", 0.3},
         {"baseColorTexture",
          {{"index", 0},
           {"extensions",
            {{"KHR_texture_transform",
              {{"offset", {0.5, 0.0}}, {"rotation", quarter}, {"scale", {2.0, 3.0}}}}}}}}}},
       {"extensions",
        {{"KHR_materials_emissive_strength", {{"emissiveStrength", 7.0}}},
         {"KHR_materials_ior", {{"ior", 1.33}}},
         {"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}}}},
      {{"alphaMode", "BLEND"},
       {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}};
  const Result<Scene> scene = load(b);
  ASSERT_TRUE(scene) << scene.error().message();
  const Material& m = scene->materials.at(0);
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_FLOAT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_FLOAT_EQ(m.metallic, 0.0f);
  EXPECT_FLOAT_EQ(m.roughness, 0.3f);
  EXPECT_EQ(m.emissive, glm::vec3(1.0f, 0.5f, 0.0f));
  EXPECT_FLOAT_EQ(m.emissive_strength, 7.0f);
  EXPECT_FLOAT_EQ(m.ior, 1.33f);
  EXPECT_FLOAT_EQ(m.transmission, 0.75f);
  // Scaled, then rotated by 90 degrees: (u, v) -> (3 v, -2 u), then shifted.
  const glm::vec3 uv = m.base_color_texture.uv_transform * glm::vec3(0.1f, 0.2f, 1.0f);
  EXPECT_NEAR(uv.x, 0.5f + 0.6f, 1e-6f);
  EXPECT_NEAR(uv.y, -0.2f, 1e-6f);
  EXPECT_EQ(scene->textures.at(0).wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(scene->textures.at(0).wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(scene->textures.at(0).filter, Filter::nearest);
  EXPECT_TRUE(scene->materials.at(1).unlit);
  EXPECT_EQ(scene->materials.at(1).alpha_mode, AlphaMode::blend);
  EXPECT_EQ(scene->notes.unsupported_extensions, std::vector<std::string>{"ACME_optional"});
}

}  // namespace
}  // namespace asos
