#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos::test::scroll_anchor_test {
using namespace ui;
namespace {

class ScrollAnchorTest : public PanelsTest {
 protected:
  ScrollAnchorTest() {
    rig.resize({660, 600});  // so that the panel is scrolled
    rig.unfold("Objects");
    (void)rig.control("section/Scene");
    EXPECT_TRUE(rig.settle());
  }
  [[nodiscard]] float height_of(const char* control) { return rig.controls().at(control).lo.y; }
  /// Removes or restores rows of the statistics, above the outline.
  [[nodiscard]] bool show_parts(bool both) {
    if (both)
      rig.scene().show_all();
    else
      rig.scene().hide(0);
    return rig.frames_until([&] {
      return rig.scene()->world().parts.size() == (both ? 2u : 1u) && !rig.scene().loading();
    }) && rig.settle();
  }
};

TEST_F(ScrollAnchorTest, WhatIsUnderThePointerStaysThere) {
  rig.move_to(rig.control("Hide").centre());
  const float held = height_of("Hide");
  const float first = height_of("section/Antialiasing");
  ASSERT_TRUE(show_parts(false));
  EXPECT_NEAR(height_of("Hide"), held, 1.5f);
  EXPECT_GT(std::abs(height_of("section/Antialiasing") - first), 5.0f) << "no row went";
  ASSERT_TRUE(show_parts(true));
  EXPECT_NEAR(height_of("Hide"), held, 1.5f);
}

TEST_F(ScrollAnchorTest, APointerOverThePictureHoldsNothing) {
  (void)rig.control("Hide");
  rig.move_to({40.0f, 200.0f});
  const float first = height_of("section/Antialiasing");
  const float before = height_of("Hide");
  ASSERT_TRUE(show_parts(false));
  EXPECT_NEAR(height_of("section/Antialiasing"), first, 0.5f);
  EXPECT_LT(height_of("Hide"), before - 5.0f);
}

// A scene that comes with warnings and notes once scrolled the panel away from its head.
TEST(ScrollAnchorAtStart, APointerThatRestsOverThePanelHoldsNothing) {
  UiRig rig{[](const std::string& source) -> Result<Scene> {
              Scene scene = two_triangles({1, 0, 0}, source);
              if (source == "noted") scene.notes.warnings = {"one", "two", "three"};
              return scene;
            },
            {660, 400}};
  rig.input().add(MouseMoved{{560.0f, 250.0f}});
  rig.frame();
  const float head = rig.controls().at("Open...").lo.y;
  rig.scene().open("noted");
  const OpenScene& scene = rig.scene();
  ASSERT_TRUE(rig.frames_until([&] { return scene && !scene->geometry->notes.warnings.empty(); }));
  ASSERT_TRUE(rig.settle());
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_EQ(rig.controls().at("Open...").lo.y, head);
}

TEST_F(ScrollAnchorTest, TheWheelScrolls) {
  const glm::vec2 over = rig.control("Hide").centre();
  rig.move_to(over);
  const float before = height_of("Hide");
  rig.wheel(over, 1.0f);
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_GT(height_of("Hide"), before + 5.0f);
}

}  // namespace
}  // namespace asos::test::scroll_anchor_test
