#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

class LensPanelTest : public test::PanelsTest {
 protected:
  LensPanelTest() { rig.unfold("Lens"); }
  [[nodiscard]] Lens lens() { return rig.previewer().viewpoint().camera().camera().lens; }
  [[nodiscard]] bool shows(const std::string& control) {
    return rig.content().controls().all().contains(control);
  }
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
  const UiState& state = rig.content().state();
  EXPECT_TRUE(state.lens.click_to_focus);
  // The middle of the picture shows a triangle.
  const Controls::Placed picture = rig.control("Picture");
  const auto click_middle = [&] {
    rig.move_to(picture.centre());
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.frame();
  };
  Viewpoint& viewpoint = rig.previewer().viewpoint();
  click_middle();
  EXPECT_FALSE(state.lens.click_to_focus);
  EXPECT_FALSE(state.picked) << "the click focuses and picks nothing";
  ASSERT_TRUE(lens().focus);
  const View view = viewpoint.view();
  const double x = 0.5 * settings().width, y = 0.5 * settings().height;
  const Hit hit = viewpoint.seen_at(x, y);
  ASSERT_TRUE(hit.valid());
  EXPECT_NEAR(*lens().focus, view.depth(view.ray(x, y), hit.t), 0.02 * *lens().focus);
  click_middle();
  EXPECT_TRUE(state.picked);
  rig.click("Auto focus");
  EXPECT_FALSE(lens().focus);
}

TEST_F(LensPanelTest, OrthographicCamerasHaveNoLens) {
  rig.click("Depth of field");
  rig.key(Key::five);
  rig.frame();
  EXPECT_FALSE(shows("Depth of field"));
  EXPECT_FALSE(lens().blurs());
  EXPECT_TRUE(rig.settle());
  rig.key(Key::five);
  EXPECT_TRUE(lens().blurs()) << "the perspective camera keeps its own";
}

}  // namespace
}  // namespace asos
