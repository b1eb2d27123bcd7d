#include "tests/ui/panels_fixture.h"
#include "ui/panels/outline_panel.h"
#include "ui/selection_outline.h"

#include <gtest/gtest.h>

#include <numbers>

// Objects are selected by a click, hidden by keys, and framed; the axes in the corner turn the
// view.

namespace asos {
using namespace ui;
namespace {

class SelectionTest : public test::PanelsTest {
 protected:
  SelectionTest() : PanelsTest(4, {900, 480}) {}
  UiState& state() { return rig.state(); }
  OpenScene& scene() { return rig.scene(); }
  void click_picture(glm::vec2 share) {
    rig.rest();
    const WindowRect picture = rig.content().layout().picture;
    rig.move_to(picture.lo + share * picture.size);
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.frame();
  }
  [[nodiscard]] bool becomes(std::size_t count) {
    return rig.frames_until(
               [&] { return scene()->world().parts.size() == count && !scene().loading(); },
               60.0) &&
           rig.settle();
  }
  void undo() { rig.chord(Key::ctrl, Key::z); }
};

TEST(SelectionOutline, IsTheBorderOfTheMask) {
  const std::vector<std::uint8_t> mask{0, 0, 0, 0, 0,  //
                                       0, 1, 1, 1, 0,  //
                                       0, 1, 1, 1, 0,  //
                                       0, 1, 1, 1, 0,  //
                                       0, 0, 0, 0, 0};
  EXPECT_EQ(
      border_of(mask, 5),
      (std::vector<PixelRun>{{1, 0, 3}, {0, 1, 5}, {0, 2, 2}, {3, 2, 2}, {0, 3, 5}, {1, 4, 3}}));
  EXPECT_TRUE(border_of({}, 5).empty());
}

TEST_F(SelectionTest, AClickSelectsAndAnotherInspects) {
  click_picture({0.5f, 0.5f});
  EXPECT_EQ(state().outline.selected, 0);
  EXPECT_FALSE(state().picked) << "no inspector yet";
  ASSERT_TRUE(rig.sleeps());
  EXPECT_EQ(selected_objects(scene(), state().outline), std::vector<int>{0});
  click_picture({0.5f, 0.5f});
  EXPECT_TRUE(state().picked);
  rig.key(Key::escape);
  EXPECT_FALSE(state().picked);
  EXPECT_EQ(state().outline.selected, 0) << "Escape closes one thing after the other";
  rig.key(Key::escape);
  EXPECT_EQ(state().outline.selected, -1);
  click_picture({0.5f, 0.5f});
  click_picture({0.02f, 0.02f});
  EXPECT_EQ(state().outline.selected, -1) << "the background";
  EXPECT_FALSE(state().picked);
  rig.input().add(KeyChanged{Key::ctrl, true});
  click_picture({0.5f, 0.5f});
  rig.input().add(KeyChanged{Key::ctrl, false});
  rig.frame();
  EXPECT_TRUE(state().picked) << "Ctrl + click inspects at once";
}

TEST_F(SelectionTest, KeysHideIsolateAndShowAndUndoTakesEachBack) {
  ASSERT_EQ(scene()->world().parts.size(), 2u);
  rig.key(Key::h);
  rig.frame();
  EXPECT_TRUE(state().message.starts_with("No object chosen")) << state().message;
  click_picture({0.5f, 0.5f});
  rig.key(Key::h);
  ASSERT_TRUE(becomes(1));
  EXPECT_EQ(scene().hidden(), std::vector<int>{0});
  undo();
  ASSERT_TRUE(becomes(2));
  EXPECT_EQ(state().message, "Undone: hidden objects");
  rig.input().add(KeyChanged{Key::shift, true});
  undo();
  rig.input().add(KeyChanged{Key::shift, false});
  ASSERT_TRUE(becomes(1)) << "done again";
  rig.input().add(KeyChanged{Key::alt, true});
  rig.key(Key::h);
  rig.input().add(KeyChanged{Key::alt, false});
  ASSERT_TRUE(becomes(2));
  click_picture({0.5f, 0.5f});
  ASSERT_EQ(state().outline.selected, 0);
  rig.chord(Key::shift, Key::h);
  ASSERT_TRUE(becomes(1));
  EXPECT_EQ(scene().hidden(), std::vector<int>{1}) << "isolated";
  undo();
  ASSERT_TRUE(becomes(2));
  undo();
  ASSERT_TRUE(becomes(1)) << "hidden before Alt + H";
  EXPECT_EQ(scene().hidden(), std::vector<int>{0});
}

TEST_F(SelectionTest, FFramesTheSelectedObject) {
  click_picture({0.5f, 0.5f});
  const OrbitCamera& camera = rig.camera();
  rig.key(Key::f);
  const Box& box = scene()->world().parts[0].bounds;
  EXPECT_NEAR(glm::distance(camera.pivot(), 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi))), 0.0,
              1e-6);
  // The sphere around its box touches the picture's border but for the margin.
  const double radius = 0.5 * glm::distance(glm::dvec3(box.lo), glm::dvec3(box.hi));
  const double half = 0.5 * camera.camera().fov_y_rad;
  EXPECT_NEAR(camera.distance() * std::sin(half) / radius, 1.15, 0.01);
}

TEST_F(SelectionTest, AxesTurnTheView) {
  const OrbitCamera& camera = rig.camera();
  const auto back = [&] { return glm::dvec3(camera.camera().world_from_camera[2]); };
  const auto& all = rig.controls();
  EXPECT_FALSE(all.contains("Axis/Y")) << "the picture is narrow";
  rig.resize({1200, 480});
  ASSERT_TRUE(rig.settle());
  for (const auto& [name, towards] : {std::pair<const char*, glm::dvec3>{"Axis/Y", {0, 1, 0}},
                                      {"Axis/-X", {-1, 0, 0}},
                                      {"Axis/Z", {0, 0, 1}}}) {
    rig.rest();
    // The ends that point to the viewer or away lie in the middle.
    rig.camera().turn_to(0.6, 0.5);
    rig.frame();
    rig.click(name);
    rig.frame();
    EXPECT_NEAR(glm::dot(back(), towards), 1.0, 1e-6) << name;
  }
  const glm::dvec3 before = back();
  rig.rest();
  const Controls::Placed square = all.at("Axes turn");
  rig.drag(square.lo + 4.0f, square.lo + glm::vec2(24.0f, 4.0f));
  EXPECT_LT(glm::dot(back(), before), 0.95) << "a drag orbits";
  display().show_axes = false;
  rig.frame();
  EXPECT_FALSE(all.contains("Axis/Y"));
}

}  // namespace
}  // namespace asos
