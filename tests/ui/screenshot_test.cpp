#include "ui/screenshot.h"

#include "renderer/film/split_map.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/ui_rig.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace asos {
using namespace ui;
namespace {

namespace fs = std::filesystem;

/// Each test has its own folder, which is also $XDG_PICTURES_DIR.
class ScreenshotTest : public testing::Test {
 protected:
  ScreenshotTest() {
    std::string name = (fs::temp_directory_path() / "asos_screenshot_XXXXXX").string();
    folder = mkdtemp(name.data());
    setenv("XDG_PICTURES_DIR", folder.c_str(), 1);
  }
  ~ScreenshotTest() override {
    unsetenv("XDG_PICTURES_DIR");
    fs::remove_all(folder);
  }
  fs::path folder;
};

TEST_F(ScreenshotTest, NamesComeFromTheScene) {
  EXPECT_EQ(screenshot_stem("builtin:office"), "office");
  EXPECT_EQ(screenshot_stem("/some/where/My Bike.glb"), "My Bike");
  EXPECT_EQ(screenshot_stem("builtin:a/b"), "a_b");
  EXPECT_EQ(screenshot_stem(""), "picture");
}

TEST_F(ScreenshotTest, CountsPastTheFilesThatExist) {
  const RgbImage image{1, 1, {1, 2, 3}, {}};
  EXPECT_EQ(save_screenshot(image, folder, "a").value(), (folder / "a-001.png").string());
  EXPECT_EQ(save_screenshot(image, folder, "a").value(), (folder / "a-002.png").string());
  EXPECT_EQ(save_screenshot(image, folder, "b").value(), (folder / "b-001.png").string());
}

TEST_F(ScreenshotTest, SaysWhyItCouldNotBeSaved) {
  const RgbImage image{1, 1, {1, 2, 3}, {}};
  const Result<std::string> saved = save_screenshot(image, folder / "missing", "a");
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message().find("missing/a-001.png"), std::string::npos);
}

TEST_F(ScreenshotTest, TheKeySavesThePictureAsSeen) {
  test::UiRig rig([](const std::string& source) -> Result<Scene> {
    return test::two_triangles({0.8f, 0.1f, 0.1f}, source);
  });
  ASSERT_TRUE(rig.opens("builtin:seen") && rig.settle());

  rig.key(Key::p);
  const std::string path = (folder / "seen-001.png").string();
  EXPECT_EQ(rig.state().message, "Saved " + path);
  const Result<RgbImage> plain = read_png(path);
  ASSERT_TRUE(plain) << plain.error().message();
  const Film& film = rig.film();
  ASSERT_EQ(plain->width, film.width);
  ASSERT_EQ(plain->height, film.height);
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const glm::u8vec3 got(plain->rgb[3 * i], plain->rgb[3 * i + 1], plain->rgb[3 * i + 2]);
    ASSERT_EQ(got, display_bytes(film, i, test::usual_display)) << "pixel " << i;
  }

  rig.state().display = {};
  rig.state().display.show_split_map = true;
  rig.state().display.split_dimming = 1.0f;
  rig.key(Key::f12);
  const Result<RgbImage> overlaid = read_png((folder / "seen-002.png").string());
  ASSERT_TRUE(overlaid) << overlaid.error().message();
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const glm::u8vec3 got(overlaid->rgb[3 * i], overlaid->rgb[3 * i + 1], overlaid->rgb[3 * i + 2]);
    ASSERT_EQ(got, SplitMapKey{}.colour(SplitMapKey{}.value(film, i))) << "pixel " << i;
  }

  rig.state().display.split_colours = SplitMapColours::cause;
  rig.key(Key::f12);
  const Result<RgbImage> by_cause = read_png((folder / "seen-003.png").string());
  ASSERT_TRUE(by_cause) << by_cause.error().message();
  for (std::size_t i = 0; i < film.cause.size(); ++i) {
    const glm::u8vec3 got(by_cause->rgb[3 * i], by_cause->rgb[3 * i + 1], by_cause->rgb[3 * i + 2]);
    ASSERT_EQ(got, split_cause_colour(film.cause[i])) << "pixel " << i;
  }
  const auto shown = [&](const char* name) {
    return read_description((folder / name).string()).value().display;
  };
  EXPECT_FALSE(shown("seen-001.png").split_map);
  EXPECT_TRUE(shown("seen-002.png").split_map);
  EXPECT_EQ(shown("seen-002.png").split_colours, SplitMapColours::level);
  EXPECT_EQ(shown("seen-003.png").split_colours, SplitMapColours::cause);
  const auto outlines = std::count(film.cause.begin(), film.cause.end(), SplitCause::outline);
  EXPECT_NE(by_cause->text.back().second.find(fmt::format("\"outline\":{}", outlines)),
            std::string::npos);
}

}  // namespace
}  // namespace asos
