#include "ui/edit_history.h"

#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class EditHistoryTest : public PanelsTest {
 protected:
  void rest() {
    for (int i = 0; i < 40; ++i) rig.frame();
  }
  void undo() { rig.chord(Key::ctrl, Key::z); }
  void redo() {
    rig.input().add(KeyChanged{Key::shift, true});
    rig.chord(Key::ctrl, Key::z);
    rig.input().add(KeyChanged{Key::shift, false});
    rig.frame();
  }
};

TEST_F(EditHistoryTest, SettingsGoBackAndForth) {
  const double eps = settings().asos.eps;
  slide("EPS", 0.5f, 0.9f);
  const double second = settings().asos.eps;
  rest();
  rig.click("Jitter unresolved cells");
  rest();
  EXPECT_TRUE(settings().asos.jitter);
  undo();
  EXPECT_FALSE(settings().asos.jitter);
  EXPECT_EQ(settings().asos.eps, second);
  undo();
  EXPECT_EQ(settings().asos.eps, eps) << "a drag is one step";
  EXPECT_TRUE(restarted());
  undo();
  EXPECT_EQ(settings().asos.eps, eps) << "nothing more to undo";
  redo();
  EXPECT_EQ(settings().asos.eps, second);
  redo();
  EXPECT_TRUE(settings().asos.jitter);
  undo();
  rig.click("Cell shading/Point sample");
  rest();
  redo();
  EXPECT_FALSE(settings().asos.jitter) << "a new step clears the redo steps";
  EXPECT_EQ(settings().asos.leaf, LeafKind::point);
}

TEST_F(EditHistoryTest, TheCameraGoesBackExactly) {
  const glm::dmat4 first = rig.camera().camera().world_from_camera;
  rig.drag({200, 200}, {260, 180});
  const glm::dmat4 second = rig.camera().camera().world_from_camera;
  // Turns of the wheel in quick succession are one step.
  rest();
  rig.wheel({200, 200}, 1.0f);
  rig.wheel({200, 200}, 1.0f);
  rest();
  undo();
  EXPECT_EQ(rig.camera().camera().world_from_camera, second);
  undo();
  EXPECT_EQ(rig.camera().camera().world_from_camera, first);
  EXPECT_TRUE(restarted());
}

TEST_F(EditHistoryTest, LightsAndDisplayGoBack) {
  const std::size_t lights = rig.edits().lights().size();
  rig.click("Add light");
  rest();
  slide("Exposure", 0.5f, 0.7f);
  EXPECT_GT(display().exposure_ev, 1.0f);
  undo();  // at once: undo ends the step
  EXPECT_EQ(display().exposure_ev, 0.0f);
  EXPECT_EQ(rig.edits().lights().size(), lights + 1);
  undo();
  EXPECT_EQ(rig.edits().lights().size(), lights);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(rig.scene()->lights().size(), lights);
  redo();
  EXPECT_TRUE(restarted());
  EXPECT_EQ(rig.scene()->lights().size(), lights + 1);
}

TEST_F(EditHistoryTest, AnotherSceneAndAnotherSizeAreNoSteps) {
  slide("EPS", 0.5f, 0.9f);
  const double eps = settings().asos.eps;
  rest();
  rig.resize({700, 1000});
  EXPECT_TRUE(rig.settle());
  const int width = settings().width;
  undo();
  EXPECT_NE(settings().asos.eps, eps);
  EXPECT_EQ(settings().width, width) << "the window's";
  redo();
  ASSERT_TRUE(rig.opens("grating"));
  rest();
  undo();
  EXPECT_EQ(settings().asos.eps, eps);
}

TEST_F(EditHistoryTest, SaysWhatWentBack) {
  const std::string& message = rig.state().message;
  slide("EPS", 0.5f, 0.9f);
  rest();
  rig.drag({200, 200}, {260, 180});
  rest();
  rig.click("Add light");
  rest();
  for (const char* what : {"lights", "camera", "EPS"}) {
    undo();
    EXPECT_EQ(message, std::string("Undone: ") + what);
  }
  redo();
  EXPECT_EQ(message, "Redone: EPS");
}

// Maps and layers are views of a picture: switching them once took an undo to get to the edit.
TEST_F(EditHistoryTest, ViewsAreNoSteps) {
  const double eps = settings().asos.eps;
  slide("EPS", 0.5f, 0.9f);
  rest();
  rig.key(Key::m);
  rest();
  rig.key(Key::c);
  rest();
  EXPECT_TRUE(display().show_split_map);
  undo();
  EXPECT_EQ(settings().asos.eps, eps);
  EXPECT_TRUE(display().show_split_map) << "the view stays";
}

TEST_F(EditHistoryTest, AnIdleWindowSleepsAfterAStep) {
  slide("EPS", 0.5f, 0.9f);
  EXPECT_TRUE(rig.settle());
  rig.move_to({-10.0f, -10.0f});
  EXPECT_TRUE(rig.sleeps());  // other threads may still work on the picture's predictions
  EXPECT_FALSE(rig.content().seconds_to_redraw().has_value());
}

}  // namespace
}  // namespace asos
