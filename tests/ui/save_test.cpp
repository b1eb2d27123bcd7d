#include "renderer/picture/picture_description.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace asos {
using namespace ui;
namespace {

class SaveTest : public test::PanelsTest {
 protected:
  SaveTest() { setenv("XDG_PICTURES_DIR", folder.path().c_str(), 1); }
  ~SaveTest() override { unsetenv("XDG_PICTURES_DIR"); }

  void open_dialog() {
    rig.chord(Key::ctrl, Key::s);
    for (int i = 0; i < 3; ++i) rig.frame();
    ASSERT_TRUE(choice().show);
  }
  bool saved(const std::string& name) {
    return rig.frames_until([&] { return rig.state().message == "Saved " + folder.file(name); },
                            20.0);
  }
  SaveChoice& choice() { return rig.state().save; }

  test::TemporaryFolder folder;
};

TEST_F(SaveTest, AnySizeIsRenderedAsItIsSaved) {
  display().exposure_ev = 0.5f;
  for (const bool exr : {true, false}) {
    open_dialog();
    rig.click(exr ? "Format/EXR" : "Format/PNG");
    choice().size = {321, 203};
    rig.frame();
    rig.click("Save");
    ASSERT_TRUE(saved(exr ? "scene-001.exr" : "scene-002.png")) << rig.state().message;
  }
  Snapshot snapshot = rig.render().snapshot();
  snapshot.settings.width = 321;
  snapshot.settings.height = 203;
  const Film whole = render_to_end(snapshot).film;
  EXPECT_TRUE(read_exr(folder.file("scene-001.exr")).value().film.radiance == whole.radiance);
  const RgbImage png = read_png(folder.file("scene-002.png")).value();
  ASSERT_EQ(png.rgb.size(), 3 * whole.radiance.size());
  for (std::size_t i = 0; i < whole.radiance.size(); ++i) {
    const glm::u8vec3 shown = display_bytes(whole, i, {0.5f, test::usual_display.tone});
    ASSERT_EQ(shown, glm::u8vec3(png.rgb[3 * i], png.rgb[3 * i + 1], png.rgb[3 * i + 2])) << i;
  }
  const PictureDescription said = read_description(folder.file("scene-002.png")).value();
  EXPECT_EQ(said.settings.width, 321);
  EXPECT_EQ(said.display.exposure_ev, 0.5f);
  EXPECT_FALSE(restarted()) << "the window's own render is unaffected";
}

// The saved picture equals the framebuffer pixel by pixel once the dialog is gone.
TEST_F(SaveTest, TheWindowIsSavedAsSeen) {
  show_all_pixels();
  rig.set_blind(false);
  display().show_split_map = true;
  rig.frame();
  open_dialog();
  rig.click("Content/Window");
  rig.click("Save");
  ASSERT_TRUE(saved("scene-001.png"));
  const RgbImage window = read_png(folder.file("scene-001.png")).value();
  EXPECT_EQ(glm::ivec2(window.width, window.height), rig.size());

  open_dialog();
  EXPECT_FALSE(rig.controls().contains("Format/EXR")) << "only of a picture";
  rig.click("Content/Viewport");
  rig.click("Save");
  ASSERT_TRUE(saved("scene-002.png"));
  const RgbImage seen = read_png(folder.file("scene-002.png")).value();
  const PixelRect area = rig.content().picture_rect();
  ASSERT_EQ(seen.width, area.width);
  ASSERT_EQ(seen.height, area.height);
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const auto i = 3 * static_cast<std::size_t>(y * seen.width + x);
      const auto in_window = static_cast<std::size_t>((area.y + y) * rig.size().x + area.x + x);
      ASSERT_EQ(glm::u8vec3(seen.rgb[i], seen.rgb[i + 1], seen.rgb[i + 2]), pixels[in_window])
          << x << "," << y;
    }
  }
  EXPECT_TRUE(read_description(folder.file("scene-002.png")).value().display.split_map);
}

TEST_F(SaveTest, CanBeStoppedAndLeavesNothing) {
  open_dialog();
  choice().size = {8000, 6000};
  rig.frame();
  rig.click("Save");
  ASSERT_TRUE(rig.frames_until([&] { return rig.controls().contains("Stop saving"); }));
  ASSERT_TRUE(rig.frames_until([&] { return !std::filesystem::is_empty(folder.path()); }))
      << "it is on its way";
  for (int i = 0; i < 3; ++i) rig.frame();  // the notice has got its place
  EXPECT_TRUE(rig.content().seconds_to_redraw().has_value()) << "the progress is shown";
  rig.click("Stop saving");
  EXPECT_TRUE(rig.frames_until([&] { return !rig.content().picture_job().state().has_value(); }));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));

  open_dialog();
  rig.click_each({"Cancel"});
  EXPECT_FALSE(choice().show);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(SaveTest, WhyItCouldNotBeSavedIsSaid) {
  open_dialog();
  choice().stem = folder.file("missing/deep");
  rig.click("Save");
  ASSERT_TRUE(rig.frames_until([&] {
    return rig.state().message.starts_with("Not saved: " + folder.file("missing/deep.png"));
  })) << rig.state().message;
}

// A dropped picture restores its display settings; a picture without settings gives an error.
TEST_F(SaveTest, SavedPicturesCanBeOpened) {
  display().exposure_ev = 1.5f;
  settings().asos.eps = 0.25;
  rig.key(Key::p);  // before the picture is finished
  ASSERT_TRUE(rig.frames_until([&] { return rig.state().message.ends_with("scene-001.png"); }));
  EXPECT_TRUE(rig.state().message.starts_with("Saved unfinished (")) << rig.state().message;
  display().exposure_ev = 0.0f;
  settings().asos.eps = 0.5;
  rig.scene().open(folder.file("scene-001.png"));
  ASSERT_TRUE(rig.frames_until([&] { return settings().asos.eps == 0.25; }));
  rig.frame();
  EXPECT_EQ(display().exposure_ev, 1.5f);

  const RgbImage plain{1, 1, {1, 2, 3}, {}};
  ASSERT_TRUE(write_png(folder.file("plain.png"), plain));
  rig.scene().open(folder.file("plain.png"));
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  EXPECT_EQ(rig.scene().error()->subject, folder.file("plain.png"));
  EXPECT_NE(rig.scene().error()->reason.find("holds no settings"), std::string::npos);
  EXPECT_EQ(settings().asos.eps, 0.25) << "the scene and its settings stay";
}

}  // namespace
}  // namespace asos
