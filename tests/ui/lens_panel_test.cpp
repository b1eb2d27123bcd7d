#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

namespace asos {
using namespace ui;
namespace {

class LensPanelTest : public test::PanelsTest {
 protected:
  LensPanelTest() { rig.unfold("Lens"); }
  [[nodiscard]] Lens lens() { return rig.camera().camera().lens; }
  [[nodiscard]] bool shows(const std::string& control) { return rig.controls().contains(control); }
};

TEST_F(LensPanelTest, SwitchesDepthOfFieldOnAndOff) {
  EXPECT_FALSE(lens().blurs());
  EXPECT_FALSE(shows("Aperture"));
  rig.click("Depth of field");
  EXPECT_TRUE(lens().blurs());
  EXPECT_FALSE(lens().focus);
  EXPECT_TRUE(restarted());
  EXPECT_TRUE(shows("Aperture"));
  EXPECT_TRUE(shows("Click to focus"));
  EXPECT_FALSE(shows("Blade turn")) << "a disk looks the same however it is turned";
  rig.click("Depth of field");
  EXPECT_FALSE(lens().blurs());
  EXPECT_TRUE(restarted());
}

TEST_F(LensPanelTest, ClickSetsFocusOnce) {
  rig.click("Depth of field");
  rig.click("Click to focus");
  const UiState& state = rig.state();
  EXPECT_TRUE(state.lens.click_to_focus);
  // Searches for a pixel that shows a triangle.
  Viewpoint& viewpoint = rig.viewpoint();
  Hit hit;
  for (float y = 100.0f; y < 900.0f && !hit.valid(); y += 50.0f) {
    rig.move_to({150.0f, y});
    rig.frame();
    if (state.hovered) hit = viewpoint.seen_at(state.hovered->x + 0.5, state.hovered->y + 0.5);
  }
  ASSERT_TRUE(hit.valid());
  const glm::ivec2 pixel = *state.hovered;
  const auto click = [&] {
    rig.rest();
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.frame();
  };
  click();
  EXPECT_FALSE(state.lens.click_to_focus);
  EXPECT_FALSE(state.picked) << "the click focuses and picks nothing";
  ASSERT_TRUE(lens().focus);
  const View view = viewpoint.view();
  const Ray ray = view.ray(pixel.x + 0.5, pixel.y + 0.5);
  EXPECT_NEAR(*lens().focus, view.depth(ray, hit.t), 1e-5 * *lens().focus);
  click();
  EXPECT_GE(state.outline.selected, 0) << "the next click selects";
  EXPECT_FALSE(state.picked);
  click();
  EXPECT_TRUE(state.picked);
  rig.click("Auto focus");
  EXPECT_FALSE(lens().focus);
}

TEST_F(LensPanelTest, OrthographicCamerasHaveNoLens) {
  rig.click("Depth of field");
  rig.key(Key::pad_five);
  rig.frame();
  EXPECT_FALSE(shows("Depth of field"));
  EXPECT_FALSE(lens().blurs());
  EXPECT_TRUE(rig.settle());
  rig.key(Key::pad_five);
  EXPECT_TRUE(lens().blurs()) << "the perspective camera keeps its own";
}

}  // namespace
}  // namespace asos
