#include "renderer/scene/posable_scene.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"
#include "tests/support/loaded_scene.h"

#include <gtest/gtest.h>

#include <random>

namespace asos {
namespace {

using test::GltfBuilder;
using test::load_in_time;
using test::TemporaryFolder;

GltfBuilder textured() {
  GltfBuilder b = GltfBuilder::square();
  auto& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  primitive["material"] = 0;
  b.json["images"] = {{{"uri", test::small_png}}};
  b.json["samplers"] = {{{"wrapS", 33071}}};
  b.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  b.json["extensionsUsed"] = {"KHR_materials_ior", "KHR_materials_specular"};
  b.json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
       {"normalTexture", {{"index", 0}}},
       {"extensions",
        {{"KHR_materials_ior", {{"ior", 1.3}}},
         {"KHR_materials_specular",
          {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 2}}}}}},
       {"extras",
        {{"asos_dfr",
          {{"min", 0.2}, {"max", {0.5, 1, 0.9}}, {"exponent", 8}, {"perturbation", 0.1}}}}}}};
  return b;
}

GltfBuilder animated() {
  GltfBuilder b = GltfBuilder::square();
  auto& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["JOINTS_0"] =
      b.accessor(b.view(std::vector<glm::u8vec4>(4, {0, 1, 0, 0})), 5121, "VEC4", 4);
  primitive["attributes"]["WEIGHTS_0"] = b.vec4(std::vector<glm::vec4>(4, {0.5f, 0.5f, 0, 0}));
  primitive["targets"] = {{{"POSITION", b.vec3(std::vector<glm::vec3>(4, {0, 0, 1}))}}};
  b.json["meshes"][0]["weights"] = {0.25};
  b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"name", "j"}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", b.mat4({glm::mat4(1.0f), glm::mat4(1.0f)})}}};
  b.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}},
       {"samplers", {{{"input", b.scalars({0, 1})}, {"output", b.vec3({{1, 0, 0}, {2, 0, 0}})}}}}}};
  return b;
}

GltfBuilder lit() {
  GltfBuilder b = GltfBuilder::square();
  const int zeros = b.accessor(-1, 5126, "VEC3", 6);
  b.json["accessors"][zeros]["sparse"] = {
      {"count", 2},
      {"indices",
       {{"bufferView", b.view(std::vector<std::uint16_t>{1, 4})}, {"componentType", 5123}}},
      {"values", {{"bufferView", b.view(std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}})}}}};
  b.primitive({{"POSITION", zeros}}, 5);
  b.json["extensionsUsed"] = {"KHR_lights_punctual", "EXT_mesh_gpu_instancing", "EXT_lights_area"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"intensity", 5}, {"color", {1, 1, 0}}, {"extras", {{"radius", 0.5}}}}};
  b.json["extensions"]["EXT_lights_area"]["lights"] = {
      {{"type", "rect"}, {"intensity", 5}, {"size", 2}, {"rect", {{"aspect", 2}}}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
  b.json["nodes"].push_back({{"camera", 0},
                             {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["nodes"].push_back({{"extensions", {{"EXT_lights_area", {{"light", 0}}}}}});
  b.json["nodes"].push_back(
      {{"extras",
        {{"asos_light",
          {{"type", "polygon"}, {"intensity", 3}, {"corners", {0, 0, 0, 2, 0, 0, 0, 2, 0}}}}}}});
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
      b.vec3({{0, 0, 0}, {3, 0, 0}});
  b.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  return b;
}

/// Returns the violated guarantees of a file, at rest and at times of its animations, and counts
/// loadable files.
std::string broken_promise_of(const std::string& path, std::size_t& loaded) {
  const Result<Scene> scene = load_in_time(path, {.keep_posable = true});
  loaded += scene.has_value() ? 1 : 0;
  if (std::string broken = test::broken_promise_of(scene, path); !broken.empty()) return broken;
  if (!scene || !scene->rig) return "";
  return test::broken_promise_of(scene->rig->pose(ClipTime{0, 0.5}), path);
}

TEST(ImportFuzz, FlippedBytesNeitherCrashNorHang) {
  const std::vector<std::string> seeds = {GltfBuilder::square().glb(), textured().glb(),
                                          animated().glb(), lit().glb(), textured().gltf()};
  const TemporaryFolder folder;
  std::mt19937 random(20240611);
  std::size_t loaded = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::size_t seed = static_cast<std::size_t>(round) % seeds.size();
    std::string bytes = seeds[seed];
    const unsigned flips = 1 + random() % 4;
    for (unsigned i = 0; i < flips; ++i) {
      // Changed digits give valid JSON with wrong values; other bytes mostly break it.
      const std::size_t at = random() % bytes.size();
      const bool digit = bytes[at] >= '0' && bytes[at] <= '9';
      bytes[at] =
          digit ? static_cast<char>('0' + random() % 10) : static_cast<char>(random() % 256);
    }
    if (round % 7 == 0) bytes.resize(random() % bytes.size());
    SCOPED_TRACE(testing::Message() << "round " << round << " of seed 20240611");
    const std::string path = folder.write("fuzz.glb", bytes);
    EXPECT_EQ(broken_promise_of(path, loaded), "");
    if (HasFailure()) break;
  }
  EXPECT_GT(loaded, 100u) << "most mutations are refused at once, so little is tested";
}

TEST(ImportFuzz, NumbersAreReplacedByUnlikelyOnes) {
  const std::vector<GltfBuilder> seeds = {GltfBuilder::square(), textured(), animated(), lit()};
  const std::vector<nlohmann::json> unlikely = {0,
                                                -1,
                                                1,
                                                3,
                                                255,
                                                65535,
                                                2147483647,
                                                2147483648u,
                                                4294967295u,
                                                18446744073709551615u,
                                                0.5,
                                                -1e300,
                                                1e300,
                                                nullptr,
                                                "text",
                                                nlohmann::json::array(),
                                                nlohmann::json::object()};
  const TemporaryFolder folder;
  std::size_t loaded = 0;
  for (const GltfBuilder& seed : seeds) {
    const nlohmann::json flat = seed.json.flatten();
    for (const auto& [pointer, value] : flat.items()) {
      for (const nlohmann::json& number : unlikely) {
        GltfBuilder b = seed;
        b.json[nlohmann::json::json_pointer(pointer)] = number;
        SCOPED_TRACE(pointer + " = " + number.dump());
        const std::string path = folder.write("fuzz.glb", b.glb());
        EXPECT_EQ(broken_promise_of(path, loaded), "");
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(loaded, 1000u);
}

}  // namespace
}  // namespace asos
