#include "renderer/scene/scene_warnings.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/shared_dir.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace asos {
using namespace ui;
namespace {

using test::GltfBuilder;
using test::UiRig;

/// Whether the text is escaped, valid UTF-8 with this number of lines.
testing::AssertionResult harmless(const std::string& text, std::size_t lines) {
  if (!is_utf8(text)) return testing::AssertionFailure() << "no UTF-8: " << printable(text);
  const auto found = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  std::string in_one_line = text;
  std::replace(in_one_line.begin(), in_one_line.end(), '\n', ' ');
  if (printable(in_one_line) != in_one_line)
    return testing::AssertionFailure() << "not escaped: " << printable(text);
  if (found != lines) return testing::AssertionFailure() << found << " lines: " << text;
  return testing::AssertionSuccess();
}

// Files that are dropped on the window while another scene is open.
class HostileFiles : public testing::Test {
 protected:
  HostileFiles() {
    rig_.set_pixel_size(3);
    ImGui::GetIO().ClipboardUserData = &copied_;
    ImGui::GetIO().SetClipboardTextFn = [](void* to, const char* text) {
      *static_cast<std::string*>(to) = text;
    };
    open(folder_.write("good.glb", GltfBuilder::square().glb()));
    EXPECT_NE(scene().get(), nullptr);
  }

  OpenScene& scene() { return rig_.scene(); }

  void open(const std::string& path) {
    scene().open(path);
    EXPECT_TRUE(rig_.frames_until([&] { return !scene().loading(); })) << path;
    rig_.frame();
  }

  std::string copied_by(const std::string& button) {
    for (int i = 0; i < 3; ++i) rig_.frame();  // the notice gets its place
    copied_.clear();
    rig_.click(button);
    return copied_;
  }

  /// Drops a file and checks what must hold for any file. Returns whether it was rejected.
  bool drop(const std::string& path) {
    SCOPED_TRACE(path);
    const std::shared_ptr<const RenderScene> before = scene().shared();
    const std::uint64_t opened = scene().times_opened();
    open(path);
    if (scene().error()) {
      EXPECT_EQ(scene().shared(), before) << "the previous scene stays";
      EXPECT_EQ(scene().times_opened(), opened);
      const std::string message = copied_by("Copy");
      EXPECT_EQ(message, scene().error()->message());
      EXPECT_FALSE(scene().error()->reason.empty());
      EXPECT_TRUE(harmless(message, 1));
      rig_.click("Close");
      EXPECT_FALSE(scene().error().has_value());
      rig_.frame();
      EXPECT_FALSE(rig_.controls().contains("Close"));
      return true;
    }
    EXPECT_NE(scene().shared(), before);
    SceneNotes notes = notes_of(*scene());
    notes.not_shown.clear();  // the window has lists for these choices
    const std::vector<std::string> lines = scene_warnings(notes);
    EXPECT_EQ(rig_.controls().contains("Copy warnings"), !lines.empty());
    if (lines.empty()) return false;
    EXPECT_TRUE(harmless(copied_by("Copy warnings"), lines.size()));
    return false;
  }

  test::TemporaryFolder folder_;
  std::string copied_;
  UiRig rig_{{}, {700, 900}};
};

TEST_F(HostileFiles, ThatCannotBeOpenedLeaveTheSceneAndSayWhy) {
  GltfBuilder far = GltfBuilder::square();
  far.node()["scale"] = {1e17, 1e17, 1e17};
  GltfBuilder required = GltfBuilder::square();
  required.json["extensionsUsed"] = {"EVIL\x1b[2J\x07\nasos: all fine\xe2\x80\xae"};
  required.json["extensionsRequired"] = required.json["extensionsUsed"];
  const std::vector<std::string> refused = {
      folder_.write("far.glb", far.glb()),
      folder_.write("required.glb", required.glb()),
      folder_.write("no.gltf", "{\"asset\":{\"version\":\"2.0\"}"),
      folder_.write("empty.glb", ""),
      folder_.write("sky.hdr", "#?RADIANCE\n\n-Y 1 +X 1\n1234"),
      folder_.write("picture.png", "\x89PNG\r\n\x1a\n"),
      folder_.write("picture.exr", "v/1\x01"),
      folder_.write("a\x1b[31m\nname\xff.glb", "glTF"),
      folder_.path().string(),
      folder_.file("absent.gltf"),
      "/dev/zero",
  };
  for (const std::string& path : refused) EXPECT_TRUE(drop(path)) << path;
  open(folder_.file("good.glb"));
  EXPECT_FALSE(scene().error().has_value()) << "it still opens what is sound";
}

TEST_F(HostileFiles, ThatCanBeOpenedShowTheirWarningsEscaped) {
  GltfBuilder b = GltfBuilder::square();
  b.node()["name"] = "\x1b]0;title\x07\nasos: all fine\r";
  b.json["extensionsUsed"] = {"EVIL\x1b[2J"};
  b.json["materials"] = {{{"name", "\x1b[1m\n\xe2\x80\xae"},
                          {"normalTexture", {{"index", 7}}},
                          {"pbrMetallicRoughness", nlohmann::json::array({1})}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  EXPECT_FALSE(drop(folder_.write("named.glb", b.glb())));
  EXPECT_FALSE(scene_warnings(notes_of(*scene())).empty());
}

TEST_F(HostileFiles, OfTheCorpusDoNoHarm) {
  const auto shared = test::shared_dir();
  if (!shared) GTEST_SKIP() << "there are no shared files";
  std::vector<std::string> files;
  for (const char* folder : {"hostile", "bad"}) {
    if (!std::filesystem::is_directory(*shared / folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             *shared / folder, std::filesystem::directory_options::follow_directory_symlink))
      if (entry.is_regular_file()) files.push_back(entry.path().string());
  }
  if (files.empty()) GTEST_SKIP() << "there are no hostile files";
  std::sort(files.begin(), files.end());
  std::size_t refused = 0;
  for (const std::string& file : files) refused += drop(file) ? 1 : 0;
  EXPECT_GT(refused, files.size() / 4);
  EXPECT_LT(refused, files.size());
}

}  // namespace
}  // namespace asos
