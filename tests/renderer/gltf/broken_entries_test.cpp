#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

// Invalid entries only affect themselves: the rest of the file is shown, and each one is reported.

namespace asos {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::load_in_time;

/// A square in the first node; tests change the second node.
GltfBuilder square_and_more() {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"].push_back(json::object());
  b.json["scenes"][0]["nodes"] = {0, 1};
  return b;
}

/// Returns the warnings about the file. Expects its square.
std::vector<std::string> remarks_on(const GltfBuilder& builder) {
  const Result<Scene> scene = load_in_time(builder);
  EXPECT_TRUE(scene) << scene.error().message();
  if (!scene) return {};
  EXPECT_EQ(scene->instanced_triangles(), 2u);
  return scene->notes.warnings;
}

void expect_said(const std::vector<std::string>& remarks, const std::string& text) {
  EXPECT_EQ(std::count(remarks.begin(), remarks.end(), text), 1) << text;
  for (const std::string& remark : remarks)
    EXPECT_EQ(remark.find("INT_MAX"), std::string::npos) << remark;
}

TEST(BrokenEntries, LightsAreLeftOut) {
  const auto with = [](const json& light) {
    GltfBuilder b = square_and_more();
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = {light, {{"type", "point"}}};
    b.json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    return b;
  };
  expect_said(remarks_on(with({{"intensity", 5}})), "light 0 has the unknown type ''; left out");
  expect_said(remarks_on(with({{"type", 3}})), "light 0 has the unknown type ''; left out");
  expect_said(remarks_on(with(7)), "light 0 has the unknown type ''; left out");
  const GltfBuilder spot = with({{"type", "spot"}, {"intensity", 5}});
  expect_said(remarks_on(spot), "light 0 is a spot without angles; glTF's defaults are used");
  const Result<Scene> scene = load_in_time(spot);
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->lights.size(), 2u);
  EXPECT_NEAR(scene->lights[1].outer_cone_rad, 0.785398, 1e-6);
}

TEST(BrokenEntries, CamerasAreLeftOut) {
  const auto with = [](const json& camera) {
    GltfBuilder b = square_and_more();
    b.json["cameras"] = {camera,
                         {{"type", "orthographic"},
                          {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 9}}}}};
    b.json["nodes"][1]["camera"] = 0;
    b.json["nodes"][0]["camera"] = 1;
    return b;
  };
  const auto left_out = [&](const json& camera, const std::string& why) {
    const std::vector<std::string> remarks = remarks_on(with(camera));
    expect_said(remarks, "camera 0 " + why + "; left out");
    EXPECT_EQ(std::count_if(remarks.begin(), remarks.end(),
                            [](const std::string& r) { return r.starts_with("camera 0"); }),
              1);
    EXPECT_EQ(load_in_time(with(camera))->cameras.size(), 1u);
  };
  left_out({{"type", "perspective"}, {"perspective", {{"znear", 1}}}}, "has no yfov");
  left_out({{"type", "perspective"}}, "has no 'perspective'");
  left_out({{"type", "fisheye"}}, "has the unknown type 'fisheye'");
  left_out({{"perspective", {{"yfov", 1}}}}, "has no type");
  left_out({{"type", "orthographic"}, {"orthographic", {{"xmag", 1}}}}, "has no xmag or ymag");
  left_out(3, "is not an object");
  // A camera with invalid planes works without them.
  const GltfBuilder endless = with({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}}}});
  expect_said(remarks_on(endless), "camera 0 has no znear; it cuts nothing off there");
  EXPECT_EQ(load_in_time(endless)->cameras.size(), 2u);
}

TEST(BrokenEntries, AccessorsAndViewsCostTheirPrimitives) {
  const auto with = [](const std::function<void(json & accessor, json & view)>& spoil) {
    GltfBuilder b = square_and_more();
    const int p = b.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    b.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", p}}}}}}});
    b.json["nodes"][1]["mesh"] = 1;
    spoil(b.json["accessors"].back(), b.json["bufferViews"].back());
    return remarks_on(b);
  };
  expect_said(with([](json& a, json&) { a = 3; }), "accessor 3 is not an object; left out");
  expect_said(with([](json& a, json&) { a.erase("type"); }), "accessor 3 has no type; left out");
  expect_said(with([](json& a, json&) { a["type"] = "VEC5"; }),
              "accessor 3 has an unknown type; left out");
  expect_said(with([](json& a, json&) { a.erase("componentType"); }),
              "accessor 3 has no componentType; left out");
  expect_said(with([](json& a, json&) { a["componentType"] = 17; }),
              "accessor 3 has an unknown componentType; left out");
  expect_said(with([](json& a, json&) { a.erase("count"); }), "accessor 3 has no count; left out");
  expect_said(with([](json& a, json&) { a["count"] = 2.5; }),
              "accessor 3 has a count that is not a whole number; left out");
  expect_said(with([](json& a, json&) { a["byteOffset"] = -4; }),
              "accessor 3 has a byteOffset that is not a whole number; left out");
  expect_said(with([](json& a, json&) {
                a["sparse"] = {{"count", "x"}};
              }),
              "accessor 3 has a sparse part that has a count that is not a whole number; left out");
  expect_said(with([](json&, json& v) { v = nullptr; }),
              "buffer view 3 is not an object; left out");
  expect_said(with([](json&, json& v) { v.erase("buffer"); }),
              "buffer view 3 has no buffer; left out");
  expect_said(with([](json&, json& v) { v.erase("byteLength"); }),
              "buffer view 3 has no byteLength; left out");
  expect_said(with([](json&, json& v) { v["byteStride"] = -1; }),
              "buffer view 3 has a byteStride that is not a whole number; left out");
}

TEST(BrokenEntries, StridesAreReadAsTheyStand) {
  // Positions as shorts with a stride of 6 bytes.
  GltfBuilder b;
  const std::vector<std::int16_t> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const int view = b.view(corners);
  b.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 6;
  b.primitive({{"POSITION", b.accessor(view, 5122, "VEC3", 3)}});
  const Result<Scene> scene = load_in_time(b);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->meshes[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  expect_said(scene->notes.warnings,
              "buffer view 0 has a byteStride of 6, which glTF does not allow; it is read by it");
  // With overlapping elements the primitive is skipped.
  for (const int stride : {2, 3}) {
    GltfBuilder more = square_and_more();
    const int p = more.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    more.json["bufferViews"].back()["byteStride"] = stride;
    more.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", p}}}}}}});
    more.json["nodes"][1]["mesh"] = 1;
    expect_said(remarks_on(more),
                "mesh 1 primitive 0 is left out: accessor 3 has elements of 12 bytes every " +
                    std::to_string(stride) + " bytes");
  }
  // Strides above 252 are readable, too.
  GltfBuilder wide;
  std::string bytes(1200, '\0');
  const float one = 1.0f;
  std::memcpy(bytes.data() + 400, &one, 4);
  std::memcpy(bytes.data() + 804, &one, 4);
  const int far = wide.view(bytes.data(), bytes.size());
  wide.json["bufferViews"][static_cast<std::size_t>(far)]["byteStride"] = 400;
  wide.primitive({{"POSITION", wide.accessor(far, 5126, "VEC3", 3)}});
  const Result<Scene> large = load_in_time(wide);
  ASSERT_TRUE(large) << large.error().message();
  EXPECT_EQ(large->meshes[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(BrokenEntries, PrimitivesMeshesAndNodesAreLeftOut) {
  GltfBuilder b = square_and_more();
  auto& primitives = b.json["meshes"][0]["primitives"];
  primitives.push_back(json::object());
  primitives.push_back(nullptr);
  primitives.push_back({{"attributes", json::object()}, {"mode", 4}});
  b.json["meshes"].push_back(5);
  b.json["nodes"][1]["mesh"] = 1;
  b.json["nodes"].push_back("node");
  b.json["materials"] = {1};
  const std::vector<std::string> remarks = remarks_on(b);
  expect_said(remarks, "mesh 0 primitive 1 has no attributes");
  expect_said(remarks, "/meshes/0/primitives/2 is not an object; left out");
  expect_said(remarks, "mesh 0 primitive 3 has no attributes");
  expect_said(remarks, "/meshes/1 is not an object; left out");
  expect_said(remarks, "/nodes/2 is not an object; left out");
  expect_said(remarks, "/materials/0 is not an object; left out");
}

TEST(BrokenEntries, SamplersOfAnimationsMoveNothing) {
  GltfBuilder b = square_and_more();
  b.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}},
       {"samplers", {{{"output", 0}}}}}};
  expect_said(remarks_on(b), "animation 0, sampler 0 has no input");
}

TEST(BrokenEntries, ColoursOfMaterialsFallBack) {
  GltfBuilder b = square_and_more();
  b.json["materials"] = {
      {{"emissiveFactor", {1, 1}}, {"doubleSided", true}},
      {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0}}, {"metallicFactor", 0.25}}}}};
  const std::vector<std::string> remarks = remarks_on(b);
  expect_said(remarks, "/materials/0/emissiveFactor is not three numbers; ignored");
  expect_said(remarks,
              "/materials/1/pbrMetallicRoughness/baseColorFactor is not four numbers; ignored");
  const Result<Scene> scene = load_in_time(b);
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->materials[0].double_sided);
  EXPECT_EQ(scene->materials[1].metallic, 0.25f);
}

}  // namespace
}  // namespace asos
