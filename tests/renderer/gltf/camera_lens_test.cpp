#include "renderer/geometry/lens.h"
#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The lens in a camera's extras.

namespace asos::test::camera_lens_test {
namespace {

using nlohmann::json;

GltfBuilder file_with(const json& lens, const std::string& type = "perspective") {
  GltfBuilder file = GltfBuilder::square();
  json camera{{"type", type}};
  if (type == "perspective")
    camera[type] = {{"yfov", 0.8}, {"znear", 0.01}};
  else
    camera[type] = {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 10}};
  if (!lens.is_null()) camera["extras"] = {{"asos_lens", lens}};
  file.json["cameras"] = json::array({camera});
  file.node()["camera"] = 0;
  return file;
}

Scene read(const GltfBuilder& file) {
  const TemporaryFolder folder;
  return load_scene(folder.write("lens.glb", file.glb())).value();
}

Lens lens_of(const Scene& scene) {
  EXPECT_EQ(scene.cameras.size(), 1u);
  return scene.cameras.empty() ? Lens{} : scene.cameras.front().lens;
}

bool warns_of(const Scene& scene, const std::string& words) {
  return std::any_of(
      scene.notes.warnings.begin(), scene.notes.warnings.end(),
      [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

TEST(CameraLens, IsReadFromExtras) {
  const Scene scene =
      read(file_with({{"aperture", 0.25}, {"focus", 3}, {"blades", 6}, {"blade_turn", 0.5}}));
  EXPECT_EQ(lens_of(scene), (Lens{0.25, 3.0, 6, 0.5}));
  EXPECT_TRUE(scene.notes.warnings.empty());
  const Lens stopped = lens_of(read(file_with({{"f_stop", 2.8}})));
  EXPECT_DOUBLE_EQ(stopped.radius, aperture_of_f_stop(2.8, 0.8));
  EXPECT_FALSE(stopped.focus);
  EXPECT_EQ(lens_of(read(file_with(nullptr))), Lens{});
}

TEST(CameraLens, BadValuesLeaveAPinholeWithARemark) {
  const auto refused = [](const json& lens, const std::string& words) {
    SCOPED_TRACE(lens.dump());
    const Scene scene = read(file_with(lens));
    EXPECT_EQ(lens_of(scene), Lens{});
    EXPECT_TRUE(warns_of(scene, "lens")) << words;
    EXPECT_TRUE(warns_of(scene, words)) << words;
  };
  refused(json::array({1}), "not an object");
  refused({{"focus", 3}}, "aperture or f_stop");
  refused({{"aperture", 1}, {"f_stop", 2}}, "aperture or f_stop");
  refused({{"aperture", -1}}, "radius");
  refused({{"aperture", 1e200}}, "radius");
  refused({{"aperture", "wide"}}, "aperture is not a number");
  refused({{"f_stop", 0}}, "f_stop of 0");
  refused({{"f_stop", -4}}, "f_stop of -4");
  refused({{"aperture", 1}, {"focus", 0}}, "focus");
  refused({{"aperture", 1}, {"focus", -3}}, "focus");
  refused({{"aperture", 1}, {"blades", 2}}, "blades");
  refused({{"aperture", 1}, {"blades", 5.5}}, "blades");
  refused({{"aperture", 1}, {"blades", 1e9}}, "blades");
  refused({{"aperture", 1}, {"blade_turn", 100}}, "turn");
}

TEST(CameraLens, OrthographicCamerasHaveNone) {
  const Scene scene = read(file_with({{"aperture", 1}}, "orthographic"));
  EXPECT_EQ(lens_of(scene), Lens{});
  EXPECT_TRUE(warns_of(scene, "orthographic"));
}

TEST(CameraLens, SurvivesExport) {
  Scene scene = read(file_with({{"aperture", 0.25}, {"focus", 3}, {"blades", 6}}));
  scene.cameras.front().lens.turn_rad = -0.75;
  const TemporaryFolder folder;
  const std::string path = folder.file("again.glb");
  ASSERT_TRUE(export_gltf(scene, path));
  EXPECT_EQ(lens_of(load_scene(path).value()), scene.cameras.front().lens);
}

}  // namespace
}  // namespace asos::test::camera_lens_test
