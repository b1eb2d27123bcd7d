#include "tests/ui/panels_fixture.h"
#include "ui/panels/section_help.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <thread>

// Faults of the panel that users reported.

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

// Rows of results once came and went, so that a button below them was missed.
TEST_F(PanelsTest, RowsStayInPlaceWhileAPictureRenders) {
  ASSERT_TRUE(rig.opens("mirrors"));
  for (const char* section : {"Compare", "Statistics", "Refinement", "Scene", "Objects"})
    rig.unfold(section);
  ASSERT_TRUE(rig.settle());
  const auto places = [&] {
    std::map<std::string, float> tops;
    for (const auto& [name, placed] : rig.controls())
      tops[name == "Stop" ? "Restart" : name] = placed.lo.y;  // one button
    return tops;
  };
  const std::map<std::string, float> before = places();
  const auto stays = [&] {
    rig.frame();
    for (const auto& [name, y] : places()) {
      if (before.contains(name) && before.at(name) == y) continue;
      ADD_FAILURE() << name << " at " << y;
      return true;
    }
    EXPECT_EQ(places().size(), before.size());
    return !rig.render().progress().running;
  };
  settings().asos.eps *= 2.0;
  ASSERT_TRUE(rig.frames_until(stays));
  settings().asos.max_level = 4;
  ASSERT_TRUE(rig.frames_until(stays));
  rig.scene().reload();
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().loading().has_value(); }));
  ASSERT_TRUE(rig.frames_until([&] { return stays() && !rig.scene().loading().has_value(); }));
}

// Texture filtering by area needs no texture samples.
TEST_F(PanelsTest, TrIsOfferedWhereItCounts) {
  ASSERT_TRUE(rig.opens("textured"));
  const auto offered = [&] {
    for (int i = 0; i < 3; ++i) rig.frame();
    return rig.controls().contains("TR");
  };
  ASSERT_EQ(settings().texture.filter, TextureFilter::footprint);
  EXPECT_FALSE(offered());
  rig.click("Texture filter/Point");
  EXPECT_TRUE(offered());
  settings().texture.resolution = 2;
  rig.click("Texture filter/Area");
  EXPECT_TRUE(offered()) << "it still takes samples";
  settings().texture.resolution = 1;
  EXPECT_FALSE(offered());
}

// The drawing once showed a split pixel with a single edge, which the default settings cut instead.
TEST(SectionHelp, DrawsPixelsAsTheDefaultSplitsThem) {
  bool cut = false, split = false;
  for (const SketchedPixel& pixel : sketched_pixels()) {
    EXPECT_TRUE(pixel.edges > 2 || pixel.levels == 0) << pixel.edges << " edges";
    cut |= pixel.edges == 1;
    split |= pixel.levels > 0;
  }
  EXPECT_TRUE(cut);
  EXPECT_TRUE(split);
}

TEST_F(PanelsTest, TheChosenObjectsTexturesAreListed) {
  ASSERT_TRUE(rig.opens("textured") && rig.settle());
  rig.unfold("Objects");
  const auto& all = rig.controls();
  rig.click_each({"Object/1"});
  ASSERT_TRUE(all.contains("Texture/Base color"));
  EXPECT_EQ(all.at("Texture/Base color").words, "Base color: RGB, opacity A, 2 x 2");
  EXPECT_FALSE(all.contains("Texture/Normal"));
  rig.click_each({"Object/2"});
  EXPECT_FALSE(all.contains("Texture/Base color")) << "its material has none";
}

// glTF is in metres; the other formats have no unit.
TEST_F(PanelsTest, TheScaleBarHasTheLengthOfThePivot) {
  rig.resize({1300, 800});
  ASSERT_TRUE(rig.settle());
  const auto& all = rig.controls();
  EXPECT_FALSE(all.contains("Scale"));
  ASSERT_TRUE(rig.opens("plain.glb") && rig.settle());
  ASSERT_TRUE(all.contains("Scale"));
  const Controls::Placed bar = all.at("Scale");
  EXPECT_EQ(bar.words, "50 cm");
  OrbitCamera& camera = rig.camera();
  const glm::dvec3 across(0.5, 0.0, 0.0);
  const View view = rig.viewpoint().view();
  const Film& film = rig.film();
  const Frame frame = view.frame(0.0, 0.0, film.width, film.height);
  const auto at = [&](glm::dvec3 p) { return frame.project(frame.homogeneous(p)).u; };
  const double pixels = (at(camera.pivot() + across) - at(camera.pivot())) * film.width;
  EXPECT_NEAR(bar.hi.x - bar.lo.x, pixels * rig.pixel_size(), 1.0);
  camera.dolly(0.25);
  rig.frame();
  EXPECT_NE(all.at("Scale").words, "50 cm");
}

TEST_F(PanelsTest, AListTakesTheWheelOnlyOnceItWasClicked) {
  ASSERT_TRUE(rig.opens("nine lights"));
  rig.resize({660, 420});
  for (int i = 0; i < 4; ++i) rig.frame();
  const glm::vec2 row = rig.control("Light/2").centre();
  const auto section_y = [&] { return rig.controls().at("section/Lights").lo.y; };
  const auto row_y = [&] { return rig.controls().at("Light/2").lo.y; };
  float section = section_y(), light = row_y();
  rig.wheel(row, -1.0f);
  rig.frame();
  EXPECT_LT(section_y(), section) << "the panel scrolls";
  EXPECT_NEAR(row_y() - light, section_y() - section, 1.0f) << "and the list does not";
  rig.click("Light/2");
  rig.click("Light/2");
  for (int i = 0; i < 3; ++i) rig.frame();
  section = section_y();
  light = row_y();
  rig.wheel(rig.controls().at("Light/3").centre(), -1.0f);
  rig.frame();
  EXPECT_EQ(section_y(), section);
  EXPECT_LT(row_y(), light) << "a clicked list scrolls";
}

// The panel once offered all controls until the scene was loaded, and then removed most of them.
TEST(Panel, OnlyGrowsWhenTheSceneComes) {
  std::atomic<bool> released = false;
  test::UiRig rig{[&](const SceneSource& source) -> Result<Scene> {
                    while (!released) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    return test::two_triangles({1, 0, 0}, source.path);
                  },
                  {660, 1000}};
  StoredSettings stored = rig.content().stored_settings();
  stored.tab = PanelTab::all;
  stored.sections["Advanced"] = true;
  rig.content().apply(stored);
  rig.scene().open("plain");
  const auto controls = [&] {
    for (int i = 0; i < 4; ++i) rig.frame();
    std::set<std::string> names;
    for (const auto& [name, placed] : rig.controls())
      if (placed.edits) names.insert(name);
    return names;
  };
  const std::set<std::string> before = controls();
  released = true;
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().get() != nullptr; }));
  ASSERT_TRUE(rig.settle());
  const std::set<std::string> after = controls();
  EXPECT_GT(before.size(), 10u);
  for (const std::string& name : before) EXPECT_TRUE(after.contains(name)) << name << " was there";
}

}  // namespace
}  // namespace asos
