#include "renderer/scene/scene_warnings.h"
#include "tests/renderer/gltf/moving_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace asos::test::animation_faults_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

/// A square with one channel that moves it.
GltfBuilder moving(const std::vector<float>& times, const std::vector<glm::vec3>& values,
                   const std::string& interpolation = "LINEAR") {
  GltfBuilder b = GltfBuilder::square();
  add_channel(b, 0, "translation", b.scalars(times), b.vec3(values), interpolation);
  return b;
}

const std::vector<glm::vec3> two{{1, 0, 0}, {2, 0, 0}};

bool said(const Scene& scene, const std::string& part) {
  return std::ranges::any_of(scene.notes.warnings, [&](const std::string& warning) {
    return warning.find(part) != std::string::npos;
  });
}

/// Expects that the channel is ignored with this warning, and that the square stays at its place in
/// the file.
void expect_ignored(const GltfBuilder& b, const std::string& why) {
  SCOPED_TRACE(why);
  const Scene scene = with_rig(b);
  EXPECT_TRUE(said(scene, "channel 0: " + why)) << testing::PrintToString(scene.notes.warnings);
  EXPECT_EQ(world_vertex(posed(scene, 0.5), 0), glm::dvec3(0.0));
  EXPECT_EQ(scene.contents.animations.at(0).channels, 1u);
  EXPECT_EQ(scene.contents.animations.at(0).moving, 0u);
}

TEST(AnimationFaults, ChannelsThatAreNotValidAreLeftOutWithTheReason) {
  expect_ignored(moving({1, 0}, two), "its times do not increase");
  expect_ignored(moving({0, nan}, two), "its times are not finite");
  expect_ignored(moving({0, endless}, two), "its times are not finite");
  expect_ignored(moving({-1, 1}, two), "its first key is before time 0");
  expect_ignored(moving({0, 1}, {{nan, 0, 0}, {0, 0, 0}}), "its values are not finite");
  expect_ignored(moving({0, 1, 2}, two), "it has 6 numbers for 3 keys, which take 9");
  expect_ignored(moving({0}, two), "it has 6 numbers for 1 keys, which take 3");
  expect_ignored(moving({0, 1}, two, "CUBICSPLINE"), "it has 6 numbers for 2 keys, which take 18");
  expect_ignored(moving({0, 1}, two, "BEZIER"), "its interpolation 'BEZIER' is unknown");

  const auto broken = [](const std::function<void(GltfBuilder&)>& change) {
    GltfBuilder b = moving({0, 1}, two);
    change(b);
    return b;
  };
  const auto target = [](GltfBuilder& b) -> nlohmann::json& {
    return b.json["animations"][0]["channels"][0]["target"];
  };
  const auto sampler = [](GltfBuilder& b) -> nlohmann::json& {
    return b.json["animations"][0]["samplers"][0];
  };
  expect_ignored(broken([&](auto& b) { target(b)["node"] = 7; }), "its node does not exist");
  expect_ignored(broken([&](auto& b) { target(b)["path"] = "colour"; }),
                 "its path 'colour' is not supported");
  expect_ignored(broken([&](auto& b) { target(b)["path"] = "weights"; }),
                 "its node has nothing to morph");
  expect_ignored(broken([&](auto& b) { target(b)["path"] = "rotation"; }), "accessor");
  expect_ignored(broken([&](auto& b) { b.json["animations"][0]["channels"][0]["sampler"] = 3; }),
                 "its sampler does not exist");
  expect_ignored(broken([&](auto& b) { sampler(b)["output"] = 99; }), "accessor 99 does not exist");
  expect_ignored(broken([&](auto& b) { sampler(b)["input"] = 99; }), "accessor 99 does not exist");
  expect_ignored(broken([&](auto& b) {
                   b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
                 }),
                 "its node has a matrix, which cannot be animated");
  expect_ignored(broken([&](auto& b) {
                   target(b)["path"] = "pointer";
                   target(b).erase("node");
                 }),
                 "its path is a pointer, which it does not have");
  GltfBuilder zero = GltfBuilder::square();
  add_channel(zero, 0, "rotation", zero.scalars({0, 1}), zero.vec4({about_z(0), glm::vec4(0)}));
  expect_ignored(zero, "a rotation of it has no direction");
}

TEST(AnimationFaults, OfTwoChannelsForOneTargetTheFirstHolds) {
  GltfBuilder b = moving({0, 1}, two);
  add_channel(b, 0, "translation", b.scalars({0, 1}), b.vec3({{9, 9, 9}, {9, 9, 9}}));
  const Scene scene = with_rig(b);
  EXPECT_TRUE(said(scene, "channel 1: another channel moves the same target"));
  EXPECT_EQ(world_vertex(posed(scene, 1), 0), glm::dvec3(2, 0, 0));
}

TEST(AnimationFaults, OfSeveralKeysAtOneTimeTheLastHolds) {
  const Scene scene = with_rig(moving({0, 1, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {7, 0, 0}}));
  EXPECT_TRUE(said(scene, "several keys at one time"));
  EXPECT_DOUBLE_EQ(world_vertex(posed(scene, 0.5), 0).x, 0.5);
  EXPECT_DOUBLE_EQ(world_vertex(posed(scene, 1.0), 0).x, 5.0);
  EXPECT_DOUBLE_EQ(world_vertex(posed(scene, 1.5), 0).x, 6.0);
}

TEST(AnimationFaults, JointsThatDoNotExistAreIgnoredWithARemark) {
  GltfBuilder b = moving({0, 1}, two);
  auto& attributes = b.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      b.accessor(b.view(std::vector<glm::u8vec4>(4, {0, 200, 0, 0})), 5121, "VEC4", 4);
  attributes["WEIGHTS_0"] = b.vec4(std::vector<glm::vec4>(4, {0.5f, 0.5f, 0, 0}));
  b.json["skins"] = {{{"joints", {0}}}};
  b.node()["skin"] = 0;
  const Scene scene = with_rig(b);
  EXPECT_TRUE(said(scene, "joint weights are negative or of joints that do not exist; ignored"));
  EXPECT_EQ(world_vertex(posed(scene, 1), 0), glm::dvec3(2, 0, 0));
}

TEST(AnimationFaults, NodeCyclesAreCutAndStillMove) {
  GltfBuilder b = moving({0, 1}, two);
  b.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {0}}}};
  const Scene scene = with_rig(b);
  EXPECT_TRUE(said(scene, "is among its own descendants"));
  EXPECT_EQ(world_vertex(posed(scene, 1), 0), glm::dvec3(2, 0, 0));
}

// A key with a huge scale places a node at infinity: there is nothing to draw at that time, but at
// others there is.
TEST(AnimationFaults, EmptyMomentIsAnError) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"] = nlohmann::json::array();
  for (int i = 0; i < 12; ++i) b.json["nodes"].push_back({{"children", {i + 1}}});
  b.json["nodes"].push_back({{"mesh", 0}});
  const int times = b.scalars({0, 1}), values = b.vec3({{1, 1, 1}, glm::vec3(3e38f)});
  for (int i = 0; i < 12; ++i) add_channel(b, i, "scale", times, values);
  const Scene scene = with_rig(b);
  EXPECT_TRUE(scene.rig->pose(ClipTime{0, 0.0}));
  const Result<Scene> far = scene.rig->pose(ClipTime{0, 1.0});
  ASSERT_FALSE(far);
  EXPECT_NE(far.error().reason.find("placed at infinity"), std::string::npos);
  EXPECT_TRUE(scene.rig->pose(ClipTime{0, 0.0}));
}

// The samplers use different ranges of the same bytes. Expanded separately, they would take a
// thousand times the memory.
TEST(AnimationFaults, OverlappingKeysUseBoundedMemory) {
  GltfBuilder b = GltfBuilder::square();
  const std::size_t count = 1 << 15;
  const int view = b.view(std::vector<float>(count + 4096, 0.0f));
  for (std::size_t i = 0; i < 1000; ++i) {
    const int values = b.accessor(view, 5126, "SCALAR", count);
    b.json["accessors"][values]["byteOffset"] = 4 * i;
    add_channel(b, 0, "translation", values, values);
  }
  for (int i = 0; i < 1000; ++i) {
    b.json["nodes"].push_back(nlohmann::json::object());
    b.json["animations"][0]["channels"][i]["target"]["node"] = i;
  }
  EXPECT_TRUE(said(with_rig(b), "more than a file of this size can hold"));
}

}  // namespace
}  // namespace asos::test::animation_faults_test
