#include "renderer/gltf/known_extensions.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace asos::import_values_test {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::load_in_time;

/// Number of warnings that contain `words`; -1 if the file was rejected.
int warnings_of(const GltfBuilder& file, const std::string& words) {
  const Result<Scene> scene = load_in_time(file);
  if (!scene) return -1;
  const auto& all = scene->notes.warnings;
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  }));
}

TEST(ImportValues, PlanesOfCamerasThatAreNoneAreSaid) {
  const auto camera = [](const char* type, const json& planes) {
    GltfBuilder b = GltfBuilder::square();
    json projection = {{"yfov", 0.7}, {"xmag", 1}, {"ymag", 1}};
    projection.update(planes);
    b.json["cameras"] = {{{"type", type}, {type, projection}}};
    return b;
  };
  const char* p = "perspective";
  const char* o = "orthographic";
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 0.0}}), "/cameras/0/perspective/znear is 0"), 1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", -1}}), "/cameras/0/perspective/znear is -1"), 1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 2}, {"zfar", 2}}), "zfar is 2, which is not beyond"),
            1);
  EXPECT_EQ(warnings_of(camera(p, {{"znear", 1}, {"zfar", 2}}), "/cameras/0"), 0);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", -1}, {"zfar", 2}}), "orthographic/znear is -1"), 1);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", 0}, {"zfar", -2}}), "zfar is -2"), 1);
  EXPECT_EQ(warnings_of(camera(o, {{"znear", 0}, {"zfar", 2}}), "/cameras/0"), 0);
}

TEST(ImportValues, FiltersAndWrapsThatAreNoneAreSaid) {
  for (const char* name : {"magFilter", "minFilter", "wrapS", "wrapT"}) {
    GltfBuilder b = GltfBuilder::square();
    b.json["samplers"] = {{{name, 5}}};
    EXPECT_EQ(warnings_of(b, std::string("/samplers/0/") + name + " is 5, which is none of"), 1);
    b.json["samplers"] = {{{name, std::string(name).starts_with("wrap") ? 33071 : 9728}}};
    EXPECT_EQ(warnings_of(b, "/samplers"), 0) << name;
  }
  // Only the minification filter may interpolate between levels.
  GltfBuilder b = GltfBuilder::square();
  b.json["samplers"] = {{{"magFilter", 9987}, {"minFilter", 9987}}};
  EXPECT_EQ(warnings_of(b, "Filter is 9987"), 1);
}

TEST(ImportValues, TexturesWithoutAnIndexAreSaid) {
  const auto of_material = [](const json& material) {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_sheen"};
    b.json["materials"] = {material};
    b.json["meshes"][0]["primitives"][0]["material"] = 0;
    return b;
  };
  const std::string what = "Texture is not a texture, which has an index";
  for (const json& empty : {json::object(), json{{"texCoord", 0}}}) {
    EXPECT_EQ(warnings_of(of_material({{"emissiveTexture", empty}}), what), 1);
    EXPECT_EQ(
        warnings_of(of_material({{"pbrMetallicRoughness", {{"baseColorTexture", empty}}}}), what),
        1);
    for (const char* name :
         {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"}) {
      const json coat = {{"clearcoatFactor", 1}, {name, empty}};
      EXPECT_EQ(
          warnings_of(of_material({{"extensions", {{"KHR_materials_clearcoat", coat}}}}), what), 1)
          << name;
    }
    const json sheen = {{"sheenColorTexture", empty}, {"sheenRoughnessTexture", empty}};
    EXPECT_EQ(warnings_of(of_material({{"extensions", {{"KHR_materials_sheen", sheen}}}}), what),
              2);
  }
}

TEST(ImportValues, TargetsThatNothingWeighsAreHeldAgainstTheAccessors) {
  GltfBuilder b = GltfBuilder::square();
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"NORMAL", 999}}};
  EXPECT_EQ(warnings_of(b, "/meshes/0/primitives/0/targets/1/NORMAL is accessor 999"), 1);
  EXPECT_EQ(warnings_of(b, "targets/0"), 0);
}

TEST(ImportValues, VersionsThatAreNoneAreSaid) {
  GltfBuilder b = GltfBuilder::square();
  for (const char* version : {"2.x", "2.", "2.0 beta", "2.0.1"}) {
    b.json["asset"]["version"] = version;
    EXPECT_EQ(warnings_of(b, std::string("/asset/version is '") + version + "'"), 1);
  }
  for (const char* version : {"2.0", "2.1"}) {
    b.json["asset"]["version"] = version;
    EXPECT_EQ(warnings_of(b, "/asset/version"), 0) << version;
  }
}

TEST(ImportValues, ExtensionsWhereTheyDoNothingAreSaid) {
  const auto at_node = [](const char* extension) {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {extension};
    b.node()["extensions"][extension] = json::object();
    return warnings_of(b, std::string("/nodes/0/extensions/") + extension + " is out of place");
  };
  for (const char* extension :
       {"KHR_implicit_shapes", "KHR_materials_ior", "KHR_texture_transform", "EXT_texture_webp",
        "EXT_lights_image_based", "KHR_animation_pointer", "KHR_draco_mesh_compression",
        "EXT_meshopt_compression", "KHR_materials_variants", "KHR_mesh_quantization"})
    EXPECT_EQ(at_node(extension), 1) << extension;
  for (const char* extension :
       {"ASOS_implicit_shape", "EXT_mesh_gpu_instancing", "KHR_node_visibility", "MSFT_lod",
        "KHR_lights_punctual", "EXT_lights_area"})
    EXPECT_EQ(at_node(extension), 0) << extension;
  EXPECT_TRUE(gltf::belongs_at("KHR_texture_transform",
                               "/materials/3/extensions/KHR_materials_sheen/sheenColorTexture"));
  EXPECT_FALSE(gltf::belongs_at("KHR_texture_transform", "/textures/0"));
  EXPECT_TRUE(gltf::belongs_at("KHR_materials_variants", "/meshes/7/primitives/12"));
  EXPECT_FALSE(gltf::belongs_at("KHR_materials_variants", "/meshes/7"));
  EXPECT_TRUE(gltf::belongs_at("KHR_lights_punctual", ""));
}

TEST(ImportValues, ListsWithoutEntriesAreSaid) {
  for (const char* name : {"translation", "rotation", "scale", "matrix"}) {
    GltfBuilder b = GltfBuilder::square();
    b.node()[name] = json::array();
    EXPECT_EQ(warnings_of(b, std::string("/nodes/0/") + name + " is not"), 1) << name;
  }
  GltfBuilder b = GltfBuilder::square();
  b.json["meshes"].push_back({{"primitives", json::array()}});
  b.json["nodes"].push_back({{"mesh", 1}});
  b.json["scenes"][0]["nodes"].push_back(1);
  EXPECT_EQ(warnings_of(b, "/meshes/1/primitives is not a list with an entry"), 1);
}

TEST(ImportValues, InstancingThatPlacesNothingIsSaid) {
  for (const json& instancing : {json::object(), json{{"attributes", json::object()}},
                                 json{{"attributes", {{"_COLOUR", 0}}}}}) {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    b.node()["extensions"]["EXT_mesh_gpu_instancing"] = instancing;
    EXPECT_EQ(warnings_of(b, "its instancing is left out: it places no copies"), 1) << instancing;
  }
}

TEST(ImportValues, TargetsThatNothingUsesYetAreJudged) {
  GltfBuilder b = GltfBuilder::square();
  auto& primitive = b.json["meshes"][0]["primitives"][0];
  const int four = b.vec3(std::vector<glm::vec3>(4)), three = b.vec3(std::vector<glm::vec3>(3));
  const int flat = b.vec2(std::vector<glm::vec2>(4));
  b.json["meshes"][0]["weights"] = {0, 0};
  primitive["targets"] = {{{"POSITION", four}, {"NORMAL", four}}, {{"POSITION", flat}}};
  EXPECT_EQ(warnings_of(b, "/targets/0"), 0);
  EXPECT_EQ(warnings_of(b, "/targets/1/POSITION is accessor 5, which is not of the type VEC3"), 1);
  primitive["targets"] = {{{"POSITION", three}}, {{"TANGENT", 99}}};
  EXPECT_EQ(warnings_of(b, "/targets/0/POSITION is accessor 4, which has another count"), 1);
  EXPECT_EQ(warnings_of(b, "/targets/1/TANGENT is accessor 99, which does not exist"), 1);
}

TEST(ImportValues, WhatTargetsHoldThatIsNotMorphedIsSaid) {
  GltfBuilder b = GltfBuilder::square();
  const int colours = b.vec4(std::vector<glm::vec4>(4));
  b.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", 0}, {"COLOR_0", colours}, {"_MINE", colours}}};
  EXPECT_EQ(warnings_of(b, "/targets/0/COLOR_0 is not morphed"), 1);
  EXPECT_EQ(warnings_of(b, "_MINE"), 0);
}

TEST(ImportValues, PropertiesThatGltfDoesNotKnowAreSaidOnce) {
  GltfBuilder b = GltfBuilder::square();
  b.node()["tranlsation"] = {1, 2, 3};
  b.json["nodes"].push_back({{"tranlsation", {1, 2, 3}}, {"name", "other"}, {"extras", 5}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColourFactor", {1, 0, 0, 1}}}}, {"unlit", true}}};
  b.json["meshs"] = json::array();
  b.json["asset"]["whatever"] = true;
  EXPECT_EQ(warnings_of(b, "/nodes has 'tranlsation', which glTF does not know; ignored"), 1);
  EXPECT_EQ(warnings_of(b, "/materials/pbrMetallicRoughness has 'baseColourFactor'"), 1);
  EXPECT_EQ(warnings_of(b, "/materials has 'unlit'"), 1);
  EXPECT_EQ(warnings_of(b, "the file has 'meshs'"), 1);
  EXPECT_EQ(warnings_of(b, "which glTF does not know"), 4);
}

TEST(ImportValues, TwoPosesOfANodeAndPositionsWithoutDataAreSaid) {
  GltfBuilder b = GltfBuilder::square();
  b.node()["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1};
  EXPECT_EQ(warnings_of(b, "has a matrix"), 0);
  b.node()["scale"] = {2, 2, 2};
  EXPECT_EQ(warnings_of(b, "/nodes/0 has a matrix, which holds, and a scale"), 1);
  EXPECT_EQ(warnings_of(b, "has no data"), 0);
  b.json["accessors"][0].erase("bufferView");
  EXPECT_EQ(warnings_of(b, "POSITION has no data: its vertices are all in one place"), 1);
}

}  // namespace
}  // namespace asos::import_values_test
