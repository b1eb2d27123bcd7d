#include "renderer/scene/posable_scene.h"
#include "tests/renderer/gltf/moving_file.h"

#include <gtest/gtest.h>

#include <algorithm>

// Animated properties of KHR_animation_pointer, besides nodes' poses: gltf/ANIMATIONS.md.

namespace asos::test::moved_values_test {
namespace {

using nlohmann::json;

constexpr const char* name = "KHR_animation_pointer";

/// A channel from time 0 to 1 that animates `pointer`.
void aim(GltfBuilder& b, const std::string& pointer, int values,
         const std::string& interpolation = "LINEAR") {
  add_channel(b, 0, "pointer", b.scalars({0, 1}), values, interpolation);
  json& target = b.json["animations"][0]["channels"].back()["target"];
  target.erase("node");
  target["extensions"][name]["pointer"] = pointer;
  b.json["extensionsUsed"] = {name,
                              "KHR_materials_clearcoat",
                              "KHR_materials_sheen",
                              "KHR_materials_anisotropy",
                              "KHR_texture_transform",
                              "KHR_lights_punctual",
                              "KHR_node_visibility"};
}

/// A square with a material, a texture, a spot light and two cameras.
GltfBuilder furnished() {
  GltfBuilder b = GltfBuilder::square();
  json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  b.json["images"] = {{{"uri", small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  const json texture = {{"index", 0}};
  json transformed = texture;
  transformed["extensions"]["KHR_texture_transform"] = json::object();
  b.json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorTexture", transformed}, {"roughnessFactor", 0.5}}},
       {"extensions",
        {{"KHR_materials_sheen", {{"sheenColorTexture", texture}}},
         {"KHR_materials_anisotropy", json::object()}}}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}},
                       {{"type", "orthographic"},
                        {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"intensity", 1}, {"spot", {{"outerConeAngle", 1.0}}}}};
  b.json["nodes"].push_back({{"camera", 0}});
  b.json["nodes"].push_back({{"camera", 1}});
  b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  return b;
}

void expect_silent(const Scene& scene) {
  EXPECT_TRUE(scene.notes.warnings.empty()) << testing::PrintToString(scene.notes.warnings);
}

TEST(MovedValues, MaterialsChangeAndComeBack) {
  GltfBuilder b = furnished();
  aim(b, "/materials/0/pbrMetallicRoughness/baseColorFactor",
      b.vec4({{0, 0, 0, 1}, {0.5, 1, 0.25, 1}}));
  aim(b, "/materials/0/pbrMetallicRoughness/roughnessFactor", b.scalars({0.5f, 1}));
  aim(b,
      "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset",
      b.vec2({{0, 0}, {1, -2}}));
  aim(b, "/materials/0/emissiveFactor", b.vec3({{0, 0, 0}, {1, 0, 0.5}}), "STEP");
  const Scene rest = with_rig(b);
  expect_silent(rest);
  EXPECT_EQ(rest.contents.animations.at(0).moving, 4u);
  EXPECT_EQ(rest.materials.at(0).base_color, glm::vec4(1));

  const Scene half = posed(rest, 0.5);
  const Material& m = half.materials.at(0);
  EXPECT_EQ(m.base_color, glm::vec4(0.25, 0.5, 0.125, 1));
  EXPECT_EQ(m.roughness, 0.75f);
  EXPECT_EQ(m.emissive, glm::vec3(0));
  EXPECT_EQ(m.base_color_texture.uv_transform[2], glm::vec3(0.5, -1, 1));
  EXPECT_EQ(posed(rest, 1.0).materials.at(0).emissive, glm::vec3(1, 0, 0.5));

  const Scene again = rest.rig->pose(std::nullopt).value();
  EXPECT_EQ(again.materials.at(0).base_color, glm::vec4(1));
  EXPECT_EQ(again.materials.at(0).roughness, 0.5f);
  EXPECT_EQ(posed(rest, 0.5).materials.at(0).base_color, m.base_color);
}

// Materials that are black, or isotropic, at rest still get their textures and tangents.
TEST(MovedValues, WhatShowsLaterHasItsTexturesAndTangents) {
  GltfBuilder b = furnished();
  aim(b, "/materials/0/extensions/KHR_materials_sheen/sheenColorFactor",
      b.vec3({{0, 0, 0}, {1, 1, 1}}));
  aim(b, "/materials/0/extensions/KHR_materials_anisotropy/anisotropyStrength", b.scalars({0, 1}));
  // A separate texture that nothing uses at rest.
  b.json["textures"].push_back({{"source", 0}});
  b.json["materials"][0]["extensions"]["KHR_materials_sheen"]["sheenColorTexture"]["index"] = 1;
  // Tangents follow the texture coordinates of the normal map, or of the anisotropy texture.
  b.json["materials"][0]["extensions"]["KHR_materials_anisotropy"]["anisotropyTexture"] = {
      {"index", 0}};
  const Scene rest = with_rig(b);
  expect_silent(rest);
  EXPECT_TRUE(rest.meshes.at(0).tangents.empty());
  const Scene half = posed(rest, 0.5);
  EXPECT_EQ(half.images.size(), rest.images.size());
  EXPECT_EQ(half.textures.size(), rest.textures.size());
  EXPECT_TRUE(half.materials.at(0).sheen.color_texture.used());
  EXPECT_EQ(half.meshes.at(0).tangents.size(), 4u);
  EXPECT_TRUE(posed(rest, 0.0).meshes.at(0).tangents.empty());
}

TEST(MovedValues, LightsAndCamerasChange) {
  GltfBuilder b = furnished();
  const std::string light = "/extensions/KHR_lights_punctual/lights/0/";
  aim(b, light + "intensity", b.scalars({1, 3}));
  aim(b, light + "color", b.vec3({{1, 1, 1}, {0, 0.5, 1}}));
  aim(b, light + "spot/outerConeAngle", b.scalars({1, 0.5f}));
  aim(b, "/cameras/0/perspective/yfov", b.scalars({1, 0.5f}));
  aim(b, "/cameras/1/orthographic/ymag", b.scalars({1, 4}));
  const Scene rest = with_rig(b);
  expect_silent(rest);
  const Scene half = posed(rest, 0.5);
  EXPECT_EQ(half.lights.at(0).intensity, 2.0f);
  EXPECT_EQ(half.lights.at(0).color, glm::vec3(0.5, 0.75, 1));
  EXPECT_EQ(half.lights.at(0).outer_cone_rad, 0.75);
  EXPECT_EQ(half.cameras.at(0).fov_y_rad, 0.75);
  EXPECT_EQ(half.cameras.at(1).height, 5.0);
  EXPECT_EQ(rest.rig->pose(std::nullopt).value().lights.at(0).intensity, 1.0f);
}

TEST(MovedValues, NodesAppearAndVanishWithAllBelowThem) {
  GltfBuilder b = furnished();
  b.json["nodes"].push_back(
      {{"children", {0}}, {"extensions", {{"KHR_node_visibility", json::object()}}}});
  b.json["scenes"][0]["nodes"] = {1, 2, 3, 4};
  aim(b, "/nodes/4/extensions/KHR_node_visibility/visible",
      b.accessor(b.view(std::vector<std::uint8_t>{1, 0}), 5121, "SCALAR", 2), "STEP");
  const Scene rest = with_rig(b);
  expect_silent(rest);
  EXPECT_EQ(rest.instances.size(), 1u);
  EXPECT_EQ(posed(rest, 0.9).instances.size(), 1u);
  EXPECT_TRUE(posed(rest, 1.0).instances.empty());
  EXPECT_EQ(posed(rest, 0.0).instances.size(), 1u);
  // Nodes keep their indices in all poses.
  EXPECT_EQ(rest.contents.nodes.size(), 5u);
  EXPECT_EQ(posed(rest, 1.0).contents.nodes.size(), 5u);
}

TEST(MovedValues, OneOfSeveralWeightsMovesAlone) {
  GltfBuilder b = furnished();
  json& mesh = b.json["meshes"][0];
  mesh["primitives"][0]["targets"] = {{{"POSITION", b.vec3(std::vector<glm::vec3>(4, {0, 0, 2}))}},
                                      {{"POSITION", b.vec3(std::vector<glm::vec3>(4, {4, 0, 0}))}}};
  mesh["weights"] = {0.5, 0.25};
  aim(b, "/nodes/0/weights/1", b.scalars({0, 1}));
  const Scene rest = with_rig(b);
  expect_silent(rest);
  EXPECT_EQ(world_vertex(rest, 0), glm::dvec3(1, 0, 1));
  EXPECT_EQ(world_vertex(posed(rest, 0.5), 0), glm::dvec3(2, 0, 1));
}

/// Expects that the channel is ignored with this warning.
void expect_left(const GltfBuilder& b, const std::string& why) {
  SCOPED_TRACE(why);
  const Scene scene = with_rig(b);
  const auto& all = scene.notes.warnings;
  EXPECT_TRUE(std::ranges::any_of(all, [&](const std::string& warning) {
    return warning.find(why) != std::string::npos;
  })) << testing::PrintToString(all);
  EXPECT_EQ(scene.contents.animations.at(0).moving + 1, scene.contents.animations.at(0).channels);
  EXPECT_TRUE(scene.rig->pose(ClipTime{0, 0.5}));
}

TEST(MovedValues, PointersThatAimAtNothingAreLeftWithTheReason) {
  const auto with = [](const std::string& pointer) {
    GltfBuilder b = furnished();
    aim(b, pointer, b.scalars({0, 1}));
    return b;
  };
  const std::string not_there = ", which the file does not have", not_read = ", which is not read";
  for (const char* pointer :
       {"/materials/1/alphaCutoff", "/materials/0/normalTexture/scale",
        "/materials/0/extensions/KHR_materials_clearcoat/clearcoatFactor",
        "/materials/0/emissiveTexture/extensions/KHR_texture_transform/rotation",
        "/cameras/0/orthographic/xmag", "/cameras/99999999999999999999/perspective/yfov",
        "/extensions/KHR_lights_punctual/lights/1/intensity"}) {
    const bool huge = std::string(pointer).find("99999") != std::string::npos;
    expect_left(with(pointer), pointer + (huge ? not_read : not_there));
  }
  for (const char* pointer : {"/materials/00/alphaCutoff", "/materials/-1/alphaCutoff",
                              "/materials//alphaCutoff", "/materials/0/doubleSided", "/materials/0",
                              "/materials", "/", "x", "/materials/0/alphaCutoff/", "/nodes/0/mesh",
                              "/meshes/0/weights", "/extensions/KHR_lights_punctual/lights/0/type"})
    expect_left(with(pointer), pointer + not_read);
}

TEST(MovedValues, ChannelsThatAreNotValidAreLeftWithTheReason) {
  const std::string cutoff = "/materials/0/alphaCutoff";
  GltfBuilder twice = furnished();
  aim(twice, cutoff, twice.scalars({0, 1}));
  aim(twice, cutoff, twice.scalars({0, 1}));
  expect_left(twice, "channel 1: another channel moves the same target");

  GltfBuilder short_of = furnished();
  aim(short_of, "/materials/0/emissiveFactor", short_of.scalars({0, 1}));
  expect_left(short_of, "channel 0: ");

  GltfBuilder smooth = furnished();
  aim(smooth, "/nodes/0/extensions/KHR_node_visibility/visible", smooth.scalars({0, 1}));
  expect_left(smooth, "what is visible only changes by steps");

  GltfBuilder weightless = furnished();
  aim(weightless, "/nodes/0/weights/3", weightless.scalars({0, 1}));
  expect_left(weightless, "its node has no weight '3'");
}

// Values out of range are clamped and reported, at the times when they occur.
TEST(MovedValues, ValuesOutOfRangeAreBroughtIntoIt) {
  GltfBuilder b = furnished();
  aim(b, "/materials/0/pbrMetallicRoughness/roughnessFactor", b.scalars({0, 3}));
  aim(b, "/cameras/0/perspective/yfov", b.scalars({1, -1}));
  const Scene rest = with_rig(b);
  expect_silent(rest);
  const Scene end = posed(rest, 1.0);
  EXPECT_EQ(end.materials.at(0).roughness, 1.0f);
  EXPECT_EQ(end.cameras.size(), 1u);
  EXPECT_EQ(end.notes.warnings.size(), 2u) << testing::PrintToString(end.notes.warnings);
  expect_silent(posed(rest, 0.25));
}

}  // namespace
}  // namespace asos::test::moved_values_test
