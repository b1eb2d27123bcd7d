#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class ReflectionsPanelTest : public PanelsTest {
 protected:
  ReflectionsPanelTest() {
    EXPECT_TRUE(rig.opens("mirrors"));
    rig.refinement().set_paused(true);  // coarse pictures are enough
    rig.frame();
    (void)begun();
  }
  /// Whether a render was started since the last call.
  bool begun() {
    EXPECT_TRUE(rig.frames_until([&] {
      return !rig.previewer().seconds_to_update(0.0) && !rig.render().first_picture_pending();
    }));
    return rig.render().restarts() > std::exchange(restarts_seen_, rig.render().restarts());
  }
  [[nodiscard]] bool shows(const std::string& name) { return rig.controls().contains(name); }
  void rest() {
    for (int i = 0; i < 40; ++i) rig.frame();
  }
  /// Draws frames until the edit is applied to the scene.
  [[nodiscard]] bool reached_scene() {
    return rig.frames_until([&] { return !rig.edits().relighting(); });
  }
  [[nodiscard]] const std::optional<Dfr>& dfr(std::size_t i) { return rig.scene()->dfrs()[i]; }

 private:
  std::uint64_t restarts_seen_ = 0;
};

TEST_F(PanelsTest, AMatteSceneHasNoReflectionsPanel) {
  EXPECT_FALSE(rig.controls().contains("section/Reflections"));
}

TEST_F(ReflectionsPanelTest, BouncesAndCurvedMirrorsRestart) {
  slide("Bounces", 0.5f, 2.0f);
  EXPECT_EQ(settings().mirror.bounces, MirrorSettings::max_bounces);
  EXPECT_TRUE(begun());
  EXPECT_FALSE(shows("Divergence"));
  rig.click_each({"Curved mirrors"});
  rig.click("Curved mirrors/adaptive");
  EXPECT_EQ(settings().mirror.curved, CurvedMirror::adaptive);
  EXPECT_TRUE(begun());
  slide("Divergence", 0.1f, 2.0f);
  EXPECT_EQ(settings().mirror.widest_angle_deg, 180.0);
  slide("Max. roughness", 0.5f, 2.0f);
  EXPECT_EQ(settings().mirror.roughest, 1.0);
  EXPECT_TRUE(validated(settings()).has_value());
  slide("Bounces", 0.9f, -1.0f);
  EXPECT_EQ(settings().mirror.bounces, 0);
  rig.frame();
  EXPECT_FALSE(shows("DFR/Per material")) << "there is no mirror then";
}

TEST_F(ReflectionsPanelTest, ThePointsOfTheCurveAreDragged) {
  rig.click("DFR/Global");
  ASSERT_TRUE(settings().mirror.dfr.has_value());
  rig.frame();
  const DfrCurve first = settings().mirror.dfr->rgb[0];
  const Controls::Placed plot = rig.control("DFR curve");
  const float step = 0.25f * (plot.hi.y - plot.lo.y);
  glm::vec2 at = rig.control("DFRMIN point").centre();
  rig.drag(at, at - glm::vec2(0.0f, step));
  EXPECT_GT(settings().mirror.dfr->rgb[0].min, first.min + 0.1);
  EXPECT_EQ(settings().mirror.dfr->rgb[0], settings().mirror.dfr->rgb[2]) << "all colours alike";
  EXPECT_TRUE(begun());
  at = rig.control("DFRMAX point").centre();
  rig.drag(at, at + glm::vec2(0.0f, step));
  EXPECT_LT(settings().mirror.dfr->rgb[1].max, first.max - 0.1);
  at = rig.control("N point").centre();
  rig.drag(at, at - glm::vec2(2.0f * step, 0.0f));
  EXPECT_LT(settings().mirror.dfr->rgb[1].exponent, 0.5 * first.exponent);
  // Drags far beyond the plot are clamped.
  for (const char* point : {"DFRMIN point", "DFRMAX point", "N point"}) {
    for (const glm::vec2 way : {glm::vec2(-900, -900), glm::vec2(900, 900)}) {
      at = rig.control(point).centre();
      rig.drag(at, at + way);
      EXPECT_TRUE(validated(settings()).has_value()) << point;
    }
  }
  EXPECT_EQ(settings().mirror.dfr->rgb[0].min, 0.0);
  EXPECT_EQ(settings().mirror.dfr->rgb[0].max, 0.0);
  EXPECT_EQ(settings().mirror.dfr->rgb[0].exponent, most_plotted_exponent);
  EXPECT_TRUE(begun()) << "the widest blur there is renders";
}

TEST_F(ReflectionsPanelTest, AColourIsEditedAloneAndUndone) {
  rig.click("DFR/Global");
  rest();
  rig.click_each({"DFR of/Blue"});
  const DfrCurve first = settings().mirror.dfr->rgb[0];
  const glm::vec2 at = rig.control("DFRMIN point").centre();
  rig.drag(at, at - glm::vec2(0.0f, 60.0f));
  EXPECT_EQ(settings().mirror.dfr->rgb[0], first);
  EXPECT_EQ(settings().mirror.dfr->rgb[1], first);
  EXPECT_GT(settings().mirror.dfr->rgb[2].min, first.min);
  rest();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_EQ(settings().mirror.dfr->rgb[2], first);
  rig.chord(Key::ctrl, Key::z);
  EXPECT_FALSE(settings().mirror.dfr.has_value());
}

TEST_F(ReflectionsPanelTest, ADoubleClickResetsAPointAndNumbersAreTyped) {
  rig.click_each({"DFR/Global"});
  const DfrCurve first = settings().mirror.dfr->rgb[0];
  const glm::vec2 at = rig.control("DFRMIN point").centre();
  rig.drag(at, at - glm::vec2(0.0f, 60.0f));
  ASSERT_NE(settings().mirror.dfr->rgb[0].min, first.min);
  rest();
  rig.click("DFRMIN point");
  rig.click("DFRMIN point");
  EXPECT_EQ(settings().mirror.dfr->rgb[0].min, first.min);
  rest();
  for (const auto& [typed, expected] :
       {std::pair<std::string, double>{"0.25", 0.25}, {"7", 1.0}, {"-1", 0.0}}) {
    (void)rig.control("DFRMAX");  // scrolls to it
    rig.input().add(KeyChanged{Key::ctrl, true});
    rig.click("DFRMAX");
    rig.input().add(KeyChanged{Key::ctrl, false});
    rig.frame();
    rig.chord(Key::ctrl, Key::a);
    rig.type(typed);
    rig.key(Key::enter);
    EXPECT_EQ(settings().mirror.dfr->rgb[1].max, expected) << typed;
  }
}

TEST_F(ReflectionsPanelTest, OneMaterialIsEditedWithoutLoadingAgain) {
  const std::uint64_t opened = rig.scene().times_opened();
  const Geometry* geometry = rig.scene()->geometry.get();
  ASSERT_FALSE(dfr(0).has_value());
  rig.click("Blur curve (DFR) instead of roughness");
  ASSERT_TRUE(reached_scene());
  ASSERT_TRUE(dfr(0).has_value());
  EXPECT_FALSE(dfr(1).has_value()) << "another material";
  EXPECT_TRUE(dfr(2).has_value()) << "looks like the first: edited with it";
  EXPECT_TRUE(begun());
  rest();
  const double before = dfr(0)->rgb[0].min;
  const glm::vec2 at = rig.control("DFRMIN point").centre();
  rig.drag(at, at - glm::vec2(0.0f, 60.0f));
  ASSERT_TRUE(reached_scene());
  EXPECT_GT(dfr(0)->rgb[0].min, before);
  EXPECT_EQ(rig.scene().times_opened(), opened);
  EXPECT_EQ(rig.scene()->geometry.get(), geometry) << "nothing is rebuilt";
  rest();
  rig.chord(Key::ctrl, Key::z);
  ASSERT_TRUE(reached_scene());
  EXPECT_EQ(dfr(0)->rgb[0].min, before);
  rig.click("Reset/Mirrors");
  ASSERT_TRUE(reached_scene());
  EXPECT_FALSE(dfr(0).has_value());
}

TEST_F(ReflectionsPanelTest, ASavedPictureBringsAnEditedMaterialBack) {
  rig.click("Blur curve (DFR) instead of roughness");
  ASSERT_TRUE(reached_scene());
  const MaterialDfrs edited = rig.edits().dfrs();
  const test::TemporaryFolder folder;
  const std::string file = folder.file("shot.png");
  PictureDescription said = rig.render().description({});
  said.scene = "mirrors";  // which is no path
  ASSERT_TRUE(
      write_png(file, {1, 1, {0, 0, 0}, {{PictureDescription::key, description_text(said)}}}));
  rig.click("Reset/Mirrors");
  ASSERT_TRUE(reached_scene());
  ASSERT_NE(rig.edits().dfrs(), edited);
  const std::uint64_t opened = rig.scene().times_opened();
  rig.scene().open(file);
  ASSERT_TRUE(
      rig.frames_until([&] { return rig.scene().times_opened() > opened || rig.scene().error(); }));
  ASSERT_FALSE(rig.scene().error()) << rig.scene().error()->message();
  EXPECT_EQ(rig.edits().dfrs(), edited);
  EXPECT_EQ(rig.scene()->dfrs(), edited);
  (void)begun();  // a running picture moves the panel's rows under the pointer
  rest();
  rig.click("Reset/Mirrors");
  EXPECT_NE(rig.edits().dfrs(), edited);
  ASSERT_TRUE(reached_scene());
  EXPECT_FALSE(dfr(0).has_value()) << "the value of the scene's file";
}

TEST_F(ReflectionsPanelTest, LightsAndMaterialsAreEditedBesideEachOther) {
  Light light;
  light.position = {0, 1, 2};
  rig.edits().edit_lights().push_back(EditedLight::of(light));
  rig.edits().edit_dfrs()[1] = Dfr{};
  ASSERT_TRUE(reached_scene());
  const std::size_t lights = rig.edits().lights().size();
  EXPECT_EQ(rig.scene()->lights().size(), lights);
  EXPECT_TRUE(dfr(1).has_value());
  rig.edits().edit_dfrs()[1].reset();
  ASSERT_TRUE(reached_scene());
  EXPECT_EQ(rig.scene()->lights().size(), lights);
  EXPECT_FALSE(dfr(1).has_value());
  rig.edits().edit_dfrs()[1] = Dfr{{DfrCurve{2.0, 1.0, 1.0}, {}, {}}, 0.0};
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  EXPECT_FALSE(dfr(1).has_value()) << "what is out of range is refused";
}

TEST_F(ReflectionsPanelTest, ThePickedPixelChoosesItsMaterialAndMarksItsAngle) {
  rig.click("Blur curve (DFR) instead of roughness");
  ASSERT_TRUE(reached_scene());
  EXPECT_FALSE(shows("Picked pixel"));
  const Film& film = rig.film();
  rig.state().picked = glm::ivec2(film.width / 2, film.height / 2);
  rig.frame();
  rig.frame();
  EXPECT_EQ(rig.state().reflections.material, 0);
  EXPECT_TRUE(shows("Picked pixel"));
  EXPECT_FALSE(rig.controls().at("Picked pixel").edits);
}

TEST_F(ReflectionsPanelTest, TheWideningIsDrawnAndTheCurveFollowsTheRatio) {
  rig.set_pixel_size(1);
  rig.click("DFR/Global");
  settings().mirror.dfr->rgb.fill({0.5, 0.5, 1.0});
  rig.move_to({-10.0f, -10.0f});
  for (int i = 0; i < 3; ++i) rig.frame();
  // The plot's area is between its handles: DFRMIN at the left, DFRMAX at the right.
  const Controls::Placed patch = rig.control("DFR patch");
  const glm::vec2 left = rig.control("DFRMIN point").centre();
  const glm::vec2 right = rig.control("DFRMAX point").centre();
  ASSERT_EQ(patch.lo, rig.control("DFR patch").lo) << "nothing scrolled";
  rig.move_to({-10.0f, -10.0f});
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  const auto brightness = [&](float x, float y) {
    const glm::u8vec3 c =
        pixels[static_cast<std::size_t>(static_cast<int>(y) * rig.size().x + static_cast<int>(x))];
    return (c.x + c.y + c.z) / 3;
  };
  EXPECT_NEAR(left.y, right.y, 1.0f);
  const float x = glm::mix(left.x, right.x, 0.3f);
  int line = 0;
  for (float y = left.y - 3.0f; y <= left.y + 3.0f; y += 1.0f)
    line = std::max(line, brightness(x, y));
  EXPECT_GT(line, 100) << "the flat curve runs at its ratio";
  // The bar below the plot: white in its centre, black at its ends.
  EXPECT_GT(brightness(x, patch.centre().y), 200);
  EXPECT_LT(brightness(x, patch.lo.y + 6.0f), 40);
}

}  // namespace
}  // namespace asos
