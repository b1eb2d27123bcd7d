#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"
#include "ui/file_watch.h"
#include "ui/stored_settings.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>

namespace asos {
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
  StoredSettings settings;
  settings.display.exposure_ev = -1.5f;
  settings.display.split_colours = SplitMapColours::cause;
  settings.show_panel = false;
  settings.watch = true;
  settings.recent = {"/a/b.glb", "/ü ö.gltf"};
  ASSERT_TRUE(save_settings(path, settings).has_value());
  const auto loaded = load_settings(path);
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(*loaded, settings);
}

TEST(StoredSettings, BadFilesAreNoHarm) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "window.json";
  EXPECT_EQ(load_settings(path).value(), StoredSettings{}) << "not there";
  EXPECT_EQ(load_settings({}).value(), StoredSettings{});
  write(path, "{ \"exposure_ev\": 1e9, \"watch\": 7, \"recent\": [1, \"/x.glb\"], \"other\": [] }");
  StoredSettings expected;
  expected.recent = {"/x.glb"};
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
  const std::string path = (folder.path() / "scene.glb").string();
  write(path, "one");
  FileWatch watch;
  EXPECT_FALSE(watch.changed(path, 0.0));
  EXPECT_FALSE(watch.changed(path, 1.1));
  write(path, "one and a half");
  EXPECT_FALSE(watch.changed(path, 1.5)) << "not yet a second";
  EXPECT_FALSE(watch.changed(path, 2.2)) << "it may still be written";
  write(path, "two");
  EXPECT_FALSE(watch.changed(path, 3.3));
  EXPECT_TRUE(watch.changed(path, 4.4));
  EXPECT_FALSE(watch.changed(path, 5.5)) << "once";
  std::filesystem::remove(path);
  EXPECT_FALSE(watch.changed(path, 6.6));
  EXPECT_FALSE(watch.changed(path, 7.7));
  write(path, "three!");
  EXPECT_FALSE(watch.changed(path, 8.8));
  EXPECT_TRUE(watch.changed(path, 9.9));
  EXPECT_NEAR(watch.seconds_to_look(10.0), 0.9, 1e-9);
  EXPECT_FALSE(watch.changed("builtin:office", 20.0));
  EXPECT_FALSE(watch.changed("builtin:office", 22.0));
}

// A file whose text says what is in it.
class WatchedFileTest : public testing::Test {
 protected:
  WatchedFileTest() {
    write(path, "red");
    rig.previewer().open(path);
    EXPECT_TRUE(rig.frames_until([&] { return rig.previewer().scene() != nullptr; }));
    EXPECT_TRUE(rig.settle());
  }
  [[nodiscard]] bool green() {
    return rig.previewer().scene()->world.materials[0].base_color.y > 0.5f;
  }

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
  const glm::dmat4 view = rig.previewer().camera().camera().world_from_camera;
  write(path, "green");
  rig.key(Key::r);
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_EQ(rig.previewer().camera().camera().world_from_camera, view);
  write(path, "red");
  rig.click("Reload");
  ASSERT_TRUE(rig.frames_until([&] { return !green(); }));
  EXPECT_EQ(rig.content().state().recent, std::vector<std::string>{path});
}

TEST_F(WatchedFileTest, WatchingSurvivesAHalfWrittenFile) {
  rig.click("Watch file");
  rig.frame();
  EXPECT_TRUE(rig.content().seconds_to_redraw().has_value()) << "it has to be looked at";
  write(path, "gre");
  ASSERT_TRUE(rig.frames_until([&] { return rig.previewer().error().has_value(); }));
  EXPECT_TRUE(rig.previewer().reload_failed());
  EXPECT_FALSE(green()) << "the scene from before stays";
  write(path, "green");
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_FALSE(rig.previewer().error().has_value());
}

TEST_F(WatchedFileTest, RecentFilesAreOffered) {
  rig.previewer().open("missing");
  rig.content().state().recent = {path};
  rig.key(Key::escape);
  rig.click("Open...");
  rig.frame();
  rig.frame();
  write(path, "green");
  rig.click("Recent/1");
  ASSERT_TRUE(rig.frames_until([&] { return green(); }));
  EXPECT_FALSE(rig.content().state().show_open);
  rig.content().state().display.exposure_ev = 2.0f;
  rig.click("Forget settings");
  EXPECT_TRUE(rig.content().state().recent.empty());
  EXPECT_EQ(rig.content().state().display, DisplaySettings{});
}

}  // namespace
}  // namespace asos
