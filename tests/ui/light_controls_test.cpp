#include "renderer/settings/names.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

// The panel's controls for light, shadows and samples, and its information about lights.

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class LightControlsTest : public PanelsTest {};

TEST_F(LightControlsTest, SobolHasSamplesInPowersOfTwoAndASeed) {
  choose_method("Sobol");
  EXPECT_EQ(settings().method, Method::sobol);
  EXPECT_TRUE(restarted());
  slide("Samples", 0.3f, 0.0f);
  EXPECT_EQ(settings().sampling.spp, 1);
  slide("Samples", 0.0f, 0.25f);
  EXPECT_EQ(settings().sampling.spp, 8);
  EXPECT_TRUE(restarted());
  slide("Seed", 0.01f, 0.5f);
  EXPECT_GT(settings().seed, 0);
  EXPECT_TRUE(restarted());
  choose_method("Beam");
  EXPECT_EQ(settings().method, Method::beam);
  rig.frame();
  for (const char* name : {"Samples", "Seed"}) EXPECT_FALSE(rig.controls().contains(name)) << name;
}

TEST_F(LightControlsTest, ShadowControlsRestart) {
  // The lights of the default lighting are area lights.
  ASSERT_TRUE(rig.scene()->lighting->default_lights_added);
  rig.click_each({"Soft shadows"});
  rig.click("Soft shadows/extended-divided");
  EXPECT_EQ(settings().shadow.quality, ShadowQuality::extended_divided);
  EXPECT_TRUE(restarted());
  slide("Divisions", 0.1f, 2.0f);
  EXPECT_EQ(settings().shadow.divisions, 16);
  slide("Divisions", 0.95f, -1.0f);
  EXPECT_EQ(settings().shadow.divisions, 1);
  EXPECT_TRUE(restarted());
  rig.click("Light rule/Published");
  EXPECT_EQ(settings().shadow.light_rule, LightRule::published);
  EXPECT_TRUE(restarted());
  rig.click("Shadows");
  EXPECT_FALSE(settings().shadow.cast);
  EXPECT_TRUE(restarted());
  rig.click("Back-face culling");
  EXPECT_FALSE(settings().cull);
  EXPECT_TRUE(restarted());
}

TEST_F(LightControlsTest, ShadowControlsAreShownWhereTheyMeanSomething) {
  const auto shown = [&](const char* name) {
    rig.frame();
    return rig.controls().contains(name);
  };
  for (const auto& [name, quality] : shadow_quality_names) {
    settings().shadow.quality = quality;
    const bool divided = quality == ShadowQuality::supersampling ||
                         quality == ShadowQuality::forced ||
                         quality == ShadowQuality::extended_divided;
    EXPECT_EQ(shown("Divisions"), divided) << name;
  }
  EXPECT_TRUE(shown("Soft shadows"));
  settings().shadow.cast = false;
  EXPECT_FALSE(shown("Soft shadows"));
  settings().shadow.cast = true;
  settings().method = Method::asos_published;  // which has its own quality
  EXPECT_FALSE(shown("Soft shadows"));
  EXPECT_FALSE(shown("Light rule/Physical"));
  settings().method = Method::sobol;
  EXPECT_FALSE(shown("Soft shadows"));
  EXPECT_TRUE(shown("Light rule/Physical"));
  settings().method = Method::asos;
  ASSERT_TRUE(rig.opens("point light"));
  EXPECT_FALSE(shown("Soft shadows"));
  EXPECT_TRUE(shown("Light rule/Physical"));
}

TEST_F(LightControlsTest, TheScenePanelCountsLightsByKind) {
  const auto shown = [&](const char* name) { return rig.controls().contains(name); };
  EXPECT_TRUE(shown("   rectangle")) << "the default lighting";
  EXPECT_FALSE(shown("   point"));
  ASSERT_TRUE(rig.opens("point light"));
  rig.frame();
  EXPECT_TRUE(shown("   point"));
  EXPECT_FALSE(shown("   rectangle"));
  EXPECT_FALSE(shown("   emissive"));
  ASSERT_TRUE(rig.opens("shining"));
  rig.frame();
  EXPECT_TRUE(shown("   emissive"));
}

TEST_F(LightControlsTest, TheStatisticsListEightLightsAndCountTheOthers) {
  ASSERT_TRUE(rig.opens("nine lights"));
  rig.frame();
  EXPECT_TRUE(rig.controls().contains("   8 point"));
  EXPECT_FALSE(rig.controls().contains("   9 point"));
  EXPECT_TRUE(rig.controls().contains("   ..."));
}

TEST_F(LightControlsTest, EveryOptionsTextFitsItsButton) {
  rig.key(Key::m);
  rig.frame();
  int looked_at = 0;
  for (const auto& [name, at] : rig.controls()) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos || name.starts_with("section/") || name.starts_with("Help/") ||
        name.starts_with("Object/"))
      continue;
    ++looked_at;
    const std::string option = name.substr(slash + 1);
    EXPECT_GT(at.hi.x - at.lo.x, ImGui::CalcTextSize(option.c_str()).x + 1.0f) << name;
    EXPECT_LE(at.hi.x, static_cast<float>(rig.size().x)) << name;
  }
  EXPECT_GE(looked_at, 18) << "six methods and twice six others";
}

}  // namespace
}  // namespace asos
