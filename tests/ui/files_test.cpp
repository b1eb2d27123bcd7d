#include "renderer/film/image_io.h"
#include "renderer/scene/source_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"
#include "ui/file_watch.h"
#include "ui/stored_settings.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;
using test::two_triangles;
using test::UiRig;

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST(StoredSettings, ComeBackAsTheyWere) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "new" / "window.json";
  StoredSettings settings{.display = {.exposure_ev = -1.5f,
                                      .tone = ToneCurve::agx,
                                      .show_grid = true,
                                      .show_legend = false,
                                      .split_colours = SplitMapColours::cause},
                          .look = {theme::Look::light, 1.25f},
                          .tour_seen = true,
                          .show_panel = false,
                          .watch = true,
                          .window_size = {1234, 777}};
  settings.look.show_bar = false;
  settings.tab = PanelTab::measure;
  settings.sections = {{"Lights", false}, {"Advanced", true}};
  settings.recent = {"/a/b.glb", "/ü ö.gltf"};
  ASSERT_TRUE(save_settings(path, settings).has_value());
  const auto loaded = load_settings(path);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(*loaded, settings);
}

// The split map is not restored: a new window would show it over another picture.
TEST(StoredSettings, TheSplitMapIsNotRemembered) {
  const test::TemporaryFolder folder;
  StoredSettings settings{.display = {.show_split_map = true}};
  ASSERT_TRUE(save_settings(folder.path() / "window.json", settings).has_value());
  EXPECT_FALSE(load_settings(folder.path() / "window.json")->display.show_split_map);
}

TEST(StoredSettings, TwoWindowsKeepWhatEachHasChanged) {
  StoredSettings before{.recent = {"/old.glb", "/forgotten.glb"}};
  StoredSettings ours = before, theirs = before;
  ours.watch = true;
  ours.recent = {"/ours.glb", "/old.glb"};
  theirs.show_panel = false;
  theirs.window_size = {900, 600};
  theirs.recent = {"/theirs.glb", "/old.glb", "/forgotten.glb"};
  const StoredSettings all = merged(before, ours, theirs);
  EXPECT_TRUE(all.watch);
  EXPECT_FALSE(all.show_panel);
  EXPECT_EQ(all.window_size, glm::ivec2(900, 600));
  EXPECT_EQ(all.recent, (std::vector<std::string>{"/ours.glb", "/old.glb", "/theirs.glb"}));
}

TEST(StoredSettings, BadFilesAreNoHarm) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "window.json";
  EXPECT_EQ(load_settings(path).value(), StoredSettings{}) << "not there";
  EXPECT_EQ(load_settings({}).value(), StoredSettings{});
  write(path,
        "{ \"exposure_ev\": 1e9, \"watch\": 7, \"window_size\": [1e99, -3], \"method\": 4, "
        "\"theme\": 1, \"ui_scale\": 99, \"tab\": \"all\", \"sections\": {\"Lights\": 7}, "
        "\"recent\": [1, \"/x.glb\"], \"other\": [] }");
  StoredSettings expected{.recent = {"/x.glb"}};
  EXPECT_EQ(load_settings(path).value(), expected);
  for (const char* text : {"", "[]", "{", "{\"recent\": \"no list\"", "\xff\xfe"}) {
    write(path, text);
    const auto refused = load_settings(path);
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().subject, path.string());
  }
}

TEST(StoredSettings, RecentFilesAreUniqueAndFew) {
  const test::TemporaryFolder folder;
  StoredSettings settings;
  settings.add_recent("builtin:office");
  settings.add_recent("/no/such.glb");
  EXPECT_TRUE(settings.recent.empty());
  for (int i = 0; i < 15; ++i) {
    const auto path = folder.path() / (std::to_string(i) + ".glb");
    write(path, "x");
    settings.add_recent(path.string());
    settings.add_recent(path.string());
  }
  EXPECT_EQ(settings.recent.size(), StoredSettings::most_recent);
  EXPECT_EQ(settings.recent.front(), (folder.path() / "14.glb").lexically_normal().string());
}

TEST(FileWatch, TellsOfAChangeOnceItRests) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("scene.gltf", "one"), side = folder.write("s.bin", "b");
  const std::string absent = folder.file("absent.png");
  const auto stamps = [&] {
    return std::vector{FileStamp::of(path), FileStamp::of(side), FileStamp::of(absent)};
  };
  std::vector<FileStamp> read = stamps();
  FileWatch watch;
  EXPECT_FALSE(watch.changed(read, 0.0));
  EXPECT_FALSE(watch.changed(read, 1.1)) << "a missing file is no change";
  for (const std::string& file : {path, side, absent}) {
    write(file, "one and a half");
    EXPECT_FALSE(watch.changed(read, 1.5)) << "not yet a second";
    EXPECT_FALSE(watch.changed(read, 2.2)) << "it may still be written";
    write(file, "two");
    EXPECT_FALSE(watch.changed(read, 3.3));
    EXPECT_TRUE(watch.changed(read, 4.4)) << file;
    read = stamps();
    EXPECT_FALSE(watch.changed(read, 5.5)) << "it was read";
    EXPECT_FALSE(watch.changed(read, 6.6));
    watch = {};
    EXPECT_FALSE(watch.changed(read, 0.0));
  }
  EXPECT_NEAR(watch.seconds_to_look(0.1), 0.9, 1e-9);
  std::filesystem::remove(side);
  EXPECT_FALSE(watch.changed(read, 1.1));
  EXPECT_FALSE(watch.changed(read, 2.2)) << "it is being replaced";
  write(side, "three!");
  EXPECT_FALSE(watch.changed(read, 3.3));
  EXPECT_TRUE(watch.changed(read, 4.4));
  EXPECT_FALSE(watch.changed({}, 20.0)) << "a built-in scene";
  EXPECT_FALSE(watch.changed({}, 22.0));
}

// A scene file whose text names its colour.
class WatchedFileTest : public testing::Test {
 protected:
  WatchedFileTest() {
    write(path, "red");
    EXPECT_TRUE(rig.opens(path) && rig.settle());
  }
  [[nodiscard]] bool green() { return rig.scene()->world().materials[0].base_color.y > 0.5f; }

  test::TemporaryFolder folder;
  std::string path = (folder.path() / "scene.glb").string();
  UiRig rig{[](const std::string& source) -> Result<Scene> {
              std::ifstream file(source);
              std::string text;
              std::getline(file, text);
              if (text == "red") return two_triangles({1, 0, 0}, source);
              if (text == "green") return two_triangles({0, 1, 0}, source);
              return unexpected(Error{source, "is not complete"});
            },
            {660, 700}};
};

TEST_F(WatchedFileTest, ReloadKeepsTheView) {
  rig.drag({100, 300}, {160, 280});
  const glm::dmat4 view = rig.camera().camera().world_from_camera;
  write(path, "green");
  rig.key(Key::r);
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_EQ(rig.camera().camera().world_from_camera, view);
  write(path, "red");
  rig.click("Reload");
  ASSERT_TRUE(rig.frames_until([&] { return !green(); }));
  EXPECT_EQ(rig.state().recent, std::vector<std::string>{path});
}

TEST_F(WatchedFileTest, WatchingSurvivesAHalfWrittenFile) {
  rig.click_each({"Watch file"});
  EXPECT_TRUE(rig.content().seconds_to_redraw().has_value()) << "the change is found by polling";
  write(path, "gre");
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  EXPECT_TRUE(rig.scene().reload_failed());
  EXPECT_FALSE(green()) << "the previous scene stays";
  write(path, "green");
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_FALSE(rig.scene().error().has_value());
}

// A .gltf with its buffer and texture in the same folder: each of them is watched, and a partly
// written one leaves the scene unchanged until it is complete.
TEST(WatchedGltf, SideFilesAreLoadedAgain) {
  const test::TemporaryFolder folder;
  const auto triangle = [](float x) {
    const float p[9] = {x, 0, 0, 1, 0, 0, 0, 1, 0};
    return std::string(reinterpret_cast<const char*>(p), sizeof p);
  };
  const auto paint = [&](std::uint8_t red) {
    const RgbImage image{1, 1, {red, 0, 0}, {}};
    ASSERT_TRUE(write_png(folder.file("a b.png"), image));
  };
  folder.write("s.bin", triangle(-1));
  paint(10);
  const std::string path = folder.write("s.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "a%20b.png"}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [-9, -9, -9], "max": [9, 9, 9]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"uri": "s.bin", "byteLength": 36}]})");
  EXPECT_EQ(source_files(path), (std::vector{path, folder.file("s.bin"), folder.file("a b.png")}));

  UiRig rig({}, {400, 300});
  rig.state().watch = true;
  ASSERT_TRUE(rig.opens(path));
  const auto width = [&] {
    const Box bounds = rig.scene()->world().bounds;
    return bounds.hi.x - bounds.lo.x;
  };
  const auto red = [&] { return rig.scene()->world().images.at(0).rgba.at(0); };
  const float narrow = width();
  EXPECT_EQ(red(), 10);
  paint(200);
  ASSERT_TRUE(rig.frames_until([&] { return red() == 200; }));
  folder.write("s.bin", triangle(-3).substr(0, 30));
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  EXPECT_TRUE(rig.scene().reload_failed());
  EXPECT_EQ(width(), narrow) << "the previous scene stays";
  folder.write("s.bin", triangle(-3));
  ASSERT_TRUE(rig.frames_until([&] { return width() != narrow; }));
  EXPECT_FALSE(rig.scene().error().has_value());
}

// "builtin:box" listed nothing, and Enter said that there is no such file.
TEST_F(WatchedFileTest, OffersBuiltInScenesWhoseNameIsHalfTyped) {
  rig.click_each({"Open..."});
  rig.frame();
  rig.type("builtin:boxe");
  rig.frame();
  rig.frame();
  EXPECT_TRUE(rig.controls().contains("Built-in/boxes"));
  EXPECT_FALSE(rig.controls().contains("Built-in/office"));
  rig.key(Key::enter);
  const auto error = [&] { return rig.scene().error(); };
  ASSERT_TRUE(rig.frames_until([&] { return error().has_value(); })) << "the rig has no such scene";
  EXPECT_EQ(error()->subject, "builtin:boxes");
}

TEST_F(WatchedFileTest, RecentFilesAreOffered) {
  rig.scene().open("missing");
  // The error's message has priority, whenever it comes.
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  rig.frame();
  rig.state().recent = {path};
  rig.key(Key::escape);
  rig.click_each({"Open..."});
  rig.frame();
  write(path, "green");
  rig.click("Recent/1");
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_FALSE(rig.state().show_open);
  EXPECT_TRUE(rig.settle());  // sections that appear at the end may move the button
  rig.state().display.exposure_ev = 2.0f;
  rig.click("Reset/Window");
  EXPECT_TRUE(rig.state().recent.empty());
  EXPECT_EQ(rig.state().display, DisplaySettings{});
}

}  // namespace
}  // namespace asos
