#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The panel's tabs, the search over all of them, and the stored state.

namespace asos {
using namespace ui;
namespace {

class PanelTabsTest : public test::PanelsTest {
 protected:
  [[nodiscard]] bool shows(const std::string& control) {
    for (int i = 0; i < 4; ++i) rig.frame();
    return rig.controls().contains(control);
  }
  UiState& state() { return rig.state(); }
};

// UiRig begins with the state of a first start.
TEST(FirstWindow, ShowsTheBarAndTheFirstTab) {
  test::UiRig rig{[](const std::string& source) -> Result<Scene> {
                    return test::two_triangles({1, 0, 0}, source);
                  },
                  {1100, 600}};
  rig.scene().open("plain");
  ASSERT_TRUE(rig.settle());
  const auto& all = rig.controls();
  EXPECT_TRUE(all.contains("Layer/Picture"));
  EXPECT_TRUE(all.contains("section/Antialiasing"));
  EXPECT_FALSE(all.contains("section/Lights"));
  (void)rig.control("section/Lights");
  EXPECT_EQ(rig.state().tab, PanelTab::scene) << "its tab was clicked";
}

TEST_F(PanelTabsTest, EachShowsItsSections) {
  for (const auto& [tab, section] :
       {std::pair<std::string, std::string>{"Antialias", "Antialiasing"},
        {"Scene", "Lights"},
        {"Measure", "Statistics"}}) {
    rig.click("Tab/" + tab);
    for (const char* other : {"Antialiasing", "Lights", "Statistics"})
      EXPECT_EQ(shows(std::string("section/") + other), other == section) << tab << ' ' << other;
  }
}

TEST_F(PanelTabsTest, SearchFindsControlsOfAllTabs) {
  state().tab = PanelTab::scene;
  rig.chord(Key::ctrl, Key::f);
  rig.frame();
  rig.type("jitter");
  EXPECT_TRUE(shows("Jitter unresolved cells"));
  EXPECT_FALSE(shows("section/Statistics"));
  EXPECT_FALSE(shows("section/Lights"));
  rig.key(Key::escape);
  for (int i = 0; i < 4; ++i) rig.frame();
  EXPECT_TRUE(state().search.empty());
  EXPECT_TRUE(shows("section/Lights"));
  EXPECT_FALSE(shows("Jitter unresolved cells"));
  state().search = "keep snap";
  EXPECT_TRUE(shows("Keep snapshot")) << "in a section that was never open";
  EXPECT_FALSE(shows("No match"));
  state().search.clear();
  rig.frame();
  // Once a letter that followed Ctrl+F at once was a shortcut: "p" saved a picture.
  InputQueue& input = rig.input();
  input.add(KeyChanged{Key::ctrl, true});
  input.add(KeyChanged{Key::f, true});
  input.add(KeyChanged{Key::f, false});
  input.add(KeyChanged{Key::ctrl, false});
  for (const auto& [key, letter] : {std::pair{Key::m, U'm'}, std::pair{Key::x, U'x'}}) {
    input.add(KeyChanged{key, true});
    input.add(TextTyped{letter});
    input.add(KeyChanged{key, false});
  }
  for (int i = 0; i < 20; ++i) rig.frame();
  EXPECT_EQ(state().search, "mx");
  EXPECT_FALSE(state().display.show_split_map) << "M is its shortcut";
  rig.key(Key::escape);
  for (const auto& [word, control] :
       {std::pair{"hdri", "section/Sky"}, std::pair{"gam", "section/Display"},
        std::pair{"FOV", "Field of view"}, std::pair{"missed", "section/Compare"}}) {
    state().search = word;
    EXPECT_TRUE(shows(control)) << word << ", a word of other programs";
    EXPECT_FALSE(shows("section/Statistics")) << word;
  }
  state().search = "no such thing";
  EXPECT_TRUE(shows("No match"));
  rig.click("Tab/Scene");
  EXPECT_TRUE(state().search.empty()) << "a tab ends the search";
}

TEST_F(PanelTabsTest, TabAndSectionsAreRememberedAndTheMethodIsNot) {
  state().tab = PanelTab::measure;
  rig.unfold("Compare");
  settings().method = Method::sobol;
  const StoredSettings stored = rig.content().stored_settings();
  EXPECT_EQ(stored.tab, PanelTab::measure);
  EXPECT_TRUE(stored.sections.at("Compare"));
  settings().method = Method::asos;
  EXPECT_EQ(rig.content().stored_settings(), stored);
  rig.content().apply(StoredSettings{});
  EXPECT_FALSE(rig.content().controls().sections().contains("Compare"));
  rig.content().apply(stored);
  rig.frame();
  EXPECT_EQ(rig.control("section/Compare").words, "open");
}

}  // namespace
}  // namespace asos
