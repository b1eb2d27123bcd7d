#include "renderer/film/image_io.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/shading/sky.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class SkyPanelTest : public PanelsTest {
 protected:
  SkyPanelTest() { rig.click_each({"section/Sky"}); }
  [[nodiscard]] const Sky* sky() { return settings().sky.get(); }
  /// A uniform sky: Radiance RGBE, 4 x 2 pixels, without run-length encoding.
  void write_sky(const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    for (int i = 0; i < 8; ++i) file.write("\x80\x40\x20\x81", 4);
  }
  [[nodiscard]] glm::vec3 corner() {
    const Film& film = rig.film();
    return film.radiance[film.index(2, film.height - 3)];
  }
};

TEST_F(SkyPanelTest, AColourSurroundsTheScene) {
  const glm::vec3 neutral = corner();
  rig.click("Sky/Colour");
  ASSERT_NE(sky(), nullptr);
  EXPECT_EQ(sky()->choice().colours->zenith, sky()->choice().colours->horizon);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(corner(), sky()->choice().colours->zenith);
  EXPECT_NE(corner(), neutral);
  slide("Brightness", 0.3f, 0.8f);
  EXPECT_GT(sky()->choice().colours->zenith.z, 0.86f);
  EXPECT_TRUE(restarted());
  rig.click("Sky/Gradient");
  EXPECT_NE(sky()->choice().colours->zenith, sky()->choice().colours->horizon);
  rig.click("Sky/Neutral");
  EXPECT_EQ(sky(), nullptr);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(corner(), neutral);
}

TEST_F(SkyPanelTest, TheBackgroundIsChosenApart) {
  rig.click("Sky/Colour");
  ASSERT_TRUE(restarted());
  rig.click("Background/Colours");
  ASSERT_TRUE(restarted());
  const Background usual;
  EXPECT_EQ(corner(), usual.top);
  EXPECT_NE(sky()->choice().colours->zenith, usual.top) << "the sky stays";
  rig.click("Background/Transparent");
  ASSERT_TRUE(restarted());
  const Film& film = rig.film();
  EXPECT_EQ(film.coverage.at(film.index(2, film.height - 3)), 0.0f);
  EXPECT_EQ(corner(), glm::vec3(0.0f));
  rig.click("Background/Environment");
  ASSERT_TRUE(restarted());
  EXPECT_EQ(corner(), sky()->choice().colours->zenith);
}

TEST_F(SkyPanelTest, AGradientStaysOneWhenItsColoursMeet) {
  rig.click("Sky/Gradient");
  settings().sky = std::make_shared<const Sky>(glm::vec3(0.5f));
  rig.frame();
  rig.frame();
  EXPECT_TRUE(rig.controls().contains("Horizon"));
}

TEST_F(SkyPanelTest, APictureIsReadAndTurned) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sky.hdr");
  write_sky(path);
  rig.click("Sky/File");
  EXPECT_EQ(sky(), nullptr) << "nothing changes before it is read";
  rig.state().sky.path = path + ".png";
  rig.click("Load sky");
  ASSERT_TRUE(rig.frames_until([&] { return !rig.state().sky.error.empty(); }));
  EXPECT_EQ(sky(), nullptr);
  rig.state().sky.path = path;
  rig.frame();
  rig.click("Load sky");
  ASSERT_TRUE(rig.frames_until([&] { return sky() != nullptr; }));
  EXPECT_TRUE(rig.state().sky.error.empty());
  EXPECT_TRUE(sky()->is_picture());
  EXPECT_EQ(sky()->choice().file, path);
  EXPECT_TRUE(restarted());
  EXPECT_NEAR(corner().x, 1.0f, 0.02f);
  EXPECT_NEAR(corner().y, 0.5f, 0.02f);
  rig.click("Load sky");
  for (int i = 0; i < 20; ++i) rig.frame();
  EXPECT_FALSE(restarted()) << "it is there already";
  rig.frame();
  slide("Turn", 0.5f, 0.75f);
  EXPECT_GT(sky()->choice().turn_deg, 45.0);
  EXPECT_LT(sky()->choice().turn_deg, 135.0);
  for (int i = 0; i < 40; ++i) rig.frame();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_EQ(sky()->choice().turn_deg, 0.0);
  EXPECT_TRUE(restarted());
  const float before = corner().x;
  slide("Brightness", 0.3f, 0.8f);
  EXPECT_GT(sky()->choice().brightness, 1.1);
  EXPECT_TRUE(restarted());
  EXPECT_NEAR(static_cast<double>(corner().x / before), sky()->choice().brightness, 1e-3);
}

TEST_F(SkyPanelTest, SaysThatAPictureIsShownWithFewerPixels) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("sky.exr");
  Film picture(6000, 3000);  // more than 2^24, in a small file
  ASSERT_TRUE(write_exr(path, picture, {}));
  rig.click("Sky/File");
  rig.state().sky.path = path;
  rig.frame();
  rig.click("Load sky");
  ASSERT_TRUE(rig.frames_until([&] { return sky() != nullptr; }));
  rig.frame();
  EXPECT_NE(rig.state().sky.remark.find("shown with 3000 x 1500"), std::string::npos)
      << rig.state().sky.remark;
  EXPECT_TRUE(rig.controls().contains("Sky remark"));
  // The next image needs no warning.
  write_sky(folder.file("small.hdr"));
  rig.state().sky.path = folder.file("small.hdr");
  rig.frame();
  rig.click("Load sky");
  ASSERT_TRUE(rig.frames_until([&] { return sky()->choice().file != path; }));
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Sky remark"));
}

// A drag over a quarter of the picture's height rotates by a quarter of 180 degrees, as in orbits.
TEST_F(SkyPanelTest, ShiftAndTheRightButtonTurnWhatSurroundsTheScene) {
  const auto key_light = [this] { return rig.scene()->lights().front(); };
  const auto middle = [this] {
    const Box bounds = rig.scene()->world().bounds;
    return 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi));
  };
  const auto drag = [this](float heights) {
    rig.input().add(KeyChanged{Key::shift, true});
    const float across = heights * rig.content().layout().picture.size.y;
    rig.drag({20, 300}, {20 + across, 300}, MouseButton::right);
    rig.input().add(KeyChanged{Key::shift, false});
    rig.frame();
  };
  const glm::dmat4 view = rig.camera().camera().world_from_camera;
  const glm::dvec3 before = key_light().position - middle();
  drag(0.25f);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(rig.camera().camera().world_from_camera, view);
  const glm::dvec3 after = key_light().position - middle();
  EXPECT_NEAR(after.y, before.y, 1e-6 * glm::length(before));
  EXPECT_NEAR(glm::length(after), glm::length(before), 1e-6 * glm::length(before));
  const auto azimuth = [](glm::dvec3 v) { return std::atan2(v.x, v.z); };
  const double turned = std::remainder(azimuth(after) - azimuth(before), 2.0 * 3.14159265358979);
  EXPECT_NEAR(turned, -0.25 * 3.14159265358979, 0.02);
  // The light still faces the scene.
  EXPECT_GT(glm::dot(key_light().direction, glm::normalize(-after)), 0.999);
  for (int i = 0; i < 40; ++i) rig.frame();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_TRUE(restarted());
  EXPECT_NEAR(glm::distance(key_light().position - middle(), before), 0.0, 1e-6);

  const test::TemporaryFolder folder;
  const std::string path = folder.file("sky.hdr");
  write_sky(path);
  rig.click("Sky/File");
  rig.state().sky.path = path;
  rig.frame();
  rig.click("Load sky");
  ASSERT_TRUE(rig.frames_until([&] { return sky() != nullptr && sky()->is_picture(); }));
  drag(-0.25f);
  EXPECT_NEAR(sky()->choice().turn_deg, 45.0, 1.0);
}

TEST_F(SkyPanelTest, APresetBringsItsSunForASceneWithoutLights) {
  const auto names = [this] {
    std::string all;
    for (const Light& light : rig.scene()->lights()) all += light.name + " ";
    return all;
  };
  // Edits in quick succession are undone together.
  const auto wait = [this] {
    for (int i = 0; i < 40; ++i) rig.frame();
  };
  const auto choose = [&](const std::string& name) {
    wait();
    rig.click("Environment/" + name);
    EXPECT_TRUE(restarted());
  };
  EXPECT_EQ(names(), "Studio key Studio fill ");
  rig.click("Sky/Preset");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(sky()->choice().environment, Environment::softboxes);
  EXPECT_EQ(names(), "Studio key Studio fill ");
  choose("daylight");
  EXPECT_EQ(sky()->choice().environment, Environment::daylight);
  EXPECT_EQ(names(), "sun ");
  choose("white");
  EXPECT_EQ(names(), "");
  wait();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(sky()->choice().environment, Environment::daylight);
  EXPECT_EQ(names(), "sun ") << "undone together";
  rig.click("Sky/Neutral");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(names(), "Studio key Studio fill ");
}

TEST_F(SkyPanelTest, AnEnvironmentIsTurnedAndBrightenedWithItsLights) {
  const auto light = [this]() -> const Light& { return rig.edits().lights()[0].light; };
  rig.click("Environment/softboxes");
  ASSERT_TRUE(restarted());
  const Light before = light();
  slide("Turn", 0.5f, 0.75f);
  ASSERT_TRUE(restarted());
  EXPECT_NEAR(sky()->choice().turn_deg, 90.0, 5.0);
  EXPECT_GT(glm::distance(light().position, before.position), 1.0);
  const Sky turned = *sky();
  const std::vector<Light> expected = lights_under(*rig.scene().shared(), &turned);
  EXPECT_NEAR(glm::distance(light().position, expected[0].position), 0.0, 1e-6);
  slide("Brightness", 0.3f, 0.8f);
  const double times = sky()->choice().brightness;
  EXPECT_GT(times, 1.1);
  EXPECT_NEAR(static_cast<double>(light().intensity), times * static_cast<double>(before.intensity),
              1e-3 * times);
  EXPECT_TRUE(restarted());
}

TEST_F(SkyPanelTest, ShiftAndTheRightButtonUpBrightenTheSky) {
  rig.click("Environment/daylight");
  ASSERT_TRUE(restarted());
  rig.input().add(KeyChanged{Key::shift, true});
  const float up = 0.25f * rig.content().layout().picture.size.y;
  rig.drag({20, 300}, {20, 300 - up}, MouseButton::right);
  rig.input().add(KeyChanged{Key::shift, false});
  rig.frame();
  EXPECT_NEAR(sky()->choice().brightness, std::sqrt(2.0), 0.02);
  EXPECT_EQ(sky()->choice().turn_deg, 0.0);
}

TEST_F(SkyPanelTest, ADroppedPictureBecomesTheSky) {
  const test::TemporaryFolder folder;
  const std::string hdr = folder.file("sky.hdr"), exr = folder.file("sky.exr");
  write_sky(hdr);
  ASSERT_TRUE(write_exr(exr, Film(16, 8), {}));
  const std::string scene = rig.scene()->geometry->source;
  for (const std::string& file : {hdr, exr}) {
    rig.content().open_dropped(file);
    ASSERT_TRUE(rig.frames_until([&] { return sky() && sky()->choice().file == file; })) << file;
    EXPECT_EQ(rig.scene()->geometry->source, scene);
  }
  rig.content().open_dropped(folder.file("missing.hdr"));
  ASSERT_TRUE(rig.frames_until([&] { return !rig.state().sky.error.empty(); }));
  EXPECT_EQ(sky()->choice().file, exr) << "the sky stays";
}

TEST_F(SkyPanelTest, BrowsesForSkies) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("my sky.hdr");
  write_sky(path);
  folder.write("model.glb", "x");
  rig.click("Sky/File");
  rig.state().sky.path = path + "x";
  rig.frame();
  rig.click_each({"Browse..."});
  rig.frame();
  const FolderListing& listing = rig.state().sky.browser.listing;
  ASSERT_EQ(listing.entries.size(), 1u) << "no models";
  EXPECT_EQ(listing.entries[0].name, "my sky.hdr");
  rig.click("Open");
  ASSERT_TRUE(rig.frames_until([&] { return sky() && sky()->is_picture(); }));
  EXPECT_EQ(sky()->choice().file, path);
}

// For large scenes, changing the ground takes seconds, in the background.
TEST_F(SkyPanelTest, TheStatusLineSaysThatTheGroundChanges) {
  const auto words = [this] { return rig.controls().at("Progress").words; };
  settings().ground = Ground::on;
  rig.frame();
  EXPECT_EQ(words(), "Updating ground");
  ASSERT_TRUE(rig.settle());
  EXPECT_TRUE(rig.frames_until([&] { return words().starts_with("Finished"); })) << words();
  settings().ground = Ground::off;
  rig.frame();
  EXPECT_EQ(words(), "Updating ground");
}

class ExposureTest : public PanelsTest {
 protected:
  void open(const std::string& source) { EXPECT_TRUE(rig.opens(source)); }
};

TEST_F(ExposureTest, FollowsABrightSceneUntilAPersonSetsIt) {
  open("sunlit");
  ASSERT_TRUE(rig.frames_until([&] { return display().auto_exposure; }));
  EXPECT_LT(display().exposure_ev, -5.0f);
  EXPECT_NE(rig.state().message.find("Auto exposure"), std::string::npos);
  EXPECT_FALSE(rig.content().stored_settings().display.auto_exposure);
  EXPECT_EQ(rig.content().stored_settings().display.exposure_ev, 0.0f) << "of this scene alone";
  // A quarter of the light's power is metered again.
  const float before = display().exposure_ev;
  rig.edits().edit_lights()[0].light.intensity *= 0.25f;
  ASSERT_TRUE(rig.frames_until([&] { return display().exposure_ev > before + 1.5f; }));
  EXPECT_TRUE(display().auto_exposure);
  rig.click_each({"Auto exposure"});
  EXPECT_FALSE(display().auto_exposure);
  EXPECT_EQ(display().exposure_ev, 0.0f);
  rig.click("Auto exposure");
  ASSERT_TRUE(rig.frames_until([&] { return display().exposure_ev < -1.0f; }));
  display().exposure_ev = 1.0f;  // as the slider does
  rig.frame();
  rig.frame();
  EXPECT_FALSE(display().auto_exposure);
  EXPECT_EQ(display().exposure_ev, 1.0f);
}

TEST_F(ExposureTest, IsThatOfEachScene) {
  open("sunlit");
  ASSERT_TRUE(rig.frames_until([&] { return display().auto_exposure; }));
  open("scene");
  EXPECT_TRUE(rig.settle());
  EXPECT_FALSE(display().auto_exposure);
  EXPECT_EQ(display().exposure_ev, 0.0f);
}

}  // namespace
}  // namespace asos
