#include "tests/support/temporary_folder.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdlib>
#include <filesystem>

// Quitting: never by Escape, and never without a question if work would be lost.

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class LeavingTest : public PanelsTest {
 protected:
  LeavingTest() { setenv("XDG_PICTURES_DIR", folder.path().c_str(), 1); }
  [[nodiscard]] UiState& state() { return rig.state(); }
  [[nodiscard]] bool shown(const char* control) { return rig.controls().contains(control); }
  void ask() {
    rig.chord(Key::ctrl, Key::q);
    rig.frame();
    rig.frame();
  }
  test::TemporaryFolder folder;
};

TEST_F(LeavingTest, EscapeClosesOneThingAfterTheOtherAndNeverQuits) {
  rig.key(Key::f1);
  EXPECT_TRUE(state().show_help);
  rig.key(Key::escape);
  EXPECT_FALSE(state().show_help);
  rig.scene().open("missing");
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().error().has_value(); }));
  rig.key(Key::escape);
  EXPECT_FALSE(rig.scene().error().has_value());
  for (int i = 0; i < 3; ++i) rig.key(Key::escape);
  EXPECT_FALSE(state().leaving.quit);
}

// It was cut off above and below at 1000x640, and at both sides of narrow windows.
TEST_F(LeavingTest, TheHelpIsInsideTheWindow) {
  rig.key(Key::f1);
  for (const glm::ivec2 size : {glm::ivec2(1000, 640), {420, 760}, {1920, 1200}}) {
    rig.resize(size);
    for (int i = 0; i < 4; ++i) rig.frame();
    const Controls::Placed help = rig.controls().at("Help");
    EXPECT_GE(help.lo.x, 0.0f);
    EXPECT_GE(help.lo.y, 0.0f);
    EXPECT_LE(help.hi.x, static_cast<float>(size.x));
    EXPECT_LE(help.hi.y, static_cast<float>(size.y));
  }
}

TEST_F(LeavingTest, EscapeClosesAListAndLeavesTheRest) {
  rig.click_each({"View"});
  state().show_help = true;  // it covers the panel of a window of this width
  rig.frame();
  ASSERT_TRUE(shown("View/front"));
  rig.key(Key::escape);
  rig.frame();
  EXPECT_FALSE(shown("View/front")) << "the list";
  EXPECT_TRUE(state().show_help) << "one thing at a time";
  EXPECT_FALSE(state().leaving.quit);
}

TEST_F(LeavingTest, EscapeAfterAClickOnASliderQuitsNothing) {
  rig.click("Exposure");
  rig.key(Key::escape);
  rig.press(MouseButton::left);
  rig.key(Key::escape);
  rig.release(MouseButton::left);
  EXPECT_FALSE(state().leaving.quit);
}

TEST_F(LeavingTest, CtrlQQuitsWhereNothingWouldBeLost) {
  ask();
  EXPECT_TRUE(state().leaving.quit);
}

TEST_F(LeavingTest, EditedLightsAreAskedAbout) {
  rig.click("Add light");
  ask();
  EXPECT_FALSE(state().leaving.quit);
  ASSERT_TRUE(shown("Quit"));
  rig.key(Key::escape);
  rig.frame();
  EXPECT_FALSE(shown("Quit"));
  EXPECT_FALSE(state().leaving.quit);
  ask();
  rig.click("Cancel");
  EXPECT_FALSE(state().leaving.quit);
  ask();
  rig.click("Quit");
  EXPECT_TRUE(state().leaving.quit);
}

// The end of the save once marked them as saved, too.
TEST_F(LeavingTest, EditsMadeWhileAPictureIsSavedAreAskedAbout) {
  ASSERT_TRUE(rig.settle());
  state().save.stem = (folder.path() / "before").string();
  state().save.asked = true;
  rig.frame();
  rig.edits().edit_lights().at(0).light.intensity = 7.0f;
  ASSERT_TRUE(rig.frames_until([&] { return state().message.starts_with("Saved "); }));
  ASSERT_TRUE(rig.settle());
  ask();
  EXPECT_TRUE(shown("Quit"));
  EXPECT_FALSE(state().leaving.quit);
}

// Only some dialogs once took Enter.
TEST_F(LeavingTest, EnterConfirmsEveryDialog) {
  const auto settled = [&] {
    for (int i = 0; i < 3; ++i) rig.frame();
  };
  state().save_scene.show = true;
  settled();
  ASSERT_TRUE(shown("Save scene"));
  state().save_scene.path = (folder.path() / "scene.glb").string();
  rig.key(Key::enter);
  settled();
  EXPECT_FALSE(state().save_scene.show);
  // A scene without a file cannot be copied.
  EXPECT_TRUE(rig.frames_until([&] { return state().message.starts_with("Not saved: "); }));
  state().save.show = true;
  settled();
  ASSERT_TRUE(shown("Save"));
  rig.key(Key::enter);
  settled();
  EXPECT_FALSE(state().save.show);
  rig.click("Add light");
  state().opening = {"grating"};
  settled();
  ASSERT_TRUE(shown("Open"));
  EXPECT_EQ(rig.scene()->geometry->source, "scene");
  rig.key(Key::enter);
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene()->geometry->source == "grating"; }));
  ASSERT_TRUE(rig.settle());
  rig.click("Add light");
  ask();
  ASSERT_TRUE(shown("Quit"));
  EXPECT_FALSE(state().leaving.quit);
  rig.key(Key::enter);
  EXPECT_TRUE(state().leaving.quit);
}

// Dropped files, the dialog, recent files and the next model of the folder all use the same
// question.
TEST_F(LeavingTest, OpeningAnotherSceneAsksAboutEditedLights) {
  const auto opened = [&] { return rig.scene()->geometry->source; };
  rig.click("Add light");
  const std::size_t lights = rig.edits().lights().size();
  state().opening = {"grating"};
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(rig.scene().loading().has_value());
  ASSERT_TRUE(shown("Open"));
  rig.click_each({"Cancel"});
  EXPECT_EQ(opened(), "scene");
  EXPECT_EQ(rig.edits().lights().size(), lights);
  state().opening = {"grating"};
  for (int i = 0; i < 3; ++i) rig.frame();
  rig.click("Open");
  ASSERT_TRUE(rig.frames_until([&] { return opened() == "grating"; }));
  ASSERT_TRUE(rig.settle());
  state().opening = {"scene"};
  rig.frame();
  EXPECT_TRUE(rig.frames_until([&] { return opened() == "scene"; })) << "nothing would be lost";
}

TEST_F(LeavingTest, ResetAndUndoneLightsAreNoEdit) {
  rig.click("Add light");
  rig.click_each({"Reset/Lights"});
  state().opening = {"grating"};
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene()->geometry->source == "grating"; }));
  ASSERT_TRUE(rig.settle());
  rig.click("Add light");
  for (int i = 0; i < 40; ++i) rig.frame();
  rig.chord(Key::ctrl, Key::z);
  rig.frame();
  state().opening = {"scene"};
  EXPECT_TRUE(rig.frames_until([&] { return rig.scene()->geometry->source == "scene"; }));
}

TEST_F(LeavingTest, ReloadingKeepsEditedLightsWithoutAQuestion) {
  rig.click("Add light");
  const std::size_t lights = rig.edits().lights().size();
  const std::uint64_t opened = rig.scene().times_opened();
  rig.key(Key::r);
  ASSERT_TRUE(rig.frames_until([&] { return rig.scene().times_opened() > opened; }));
  rig.frame();
  EXPECT_EQ(rig.edits().lights().size(), lights);
  EXPECT_EQ(state().message, "Kept 1 light edit");
  ask();
  EXPECT_TRUE(shown("Quit")) << "it is not saved yet";
}

TEST_F(LeavingTest, TheDialogAsksAboutEditedLights) {
  rig.click("Add light");
  rig.chord(Key::ctrl, Key::o);
  for (int i = 0; i < 3; ++i) rig.frame();
  rig.click("Built-in/office");
  for (int i = 0; i < 3; ++i) rig.frame();
  EXPECT_FALSE(rig.scene().loading().has_value());
  EXPECT_EQ(state().opening.wanted, "builtin:office");
  ASSERT_TRUE(shown("Open"));
  rig.click_each({"Cancel"});
  EXPECT_TRUE(state().opening.wanted.empty());
}

TEST_F(LeavingTest, AskingTwiceIsMeant) {
  rig.click("Add light");
  ask();
  ask();
  EXPECT_TRUE(state().leaving.quit);
}

// A saved picture contains the lights.
TEST_F(LeavingTest, WhatASavedPictureHoldsIsNotLost) {
  rig.click("Add light");
  EXPECT_TRUE(restarted());
  rig.key(Key::p);
  ask();
  EXPECT_TRUE(state().leaving.quit);
}

TEST_F(LeavingTest, StoredFramesAreAskedAbout) {
  rig.key(Key::s);
  EXPECT_EQ(state().frames.stored.size(), 1u);
  rig.frame();
  EXPECT_EQ(state().message, "Kept 1: ASOS, EPS 1/256, MAX 2");
  state().leaving.asked = true;  // as by the window's close button
  rig.frame();
  rig.frame();
  EXPECT_TRUE(shown("Quit"));
  EXPECT_FALSE(state().leaving.quit);
}

TEST_F(LeavingTest, APictureThatIsBeingSavedIsWaitedFor) {
  rig.chord(Key::ctrl, Key::s);
  rig.frame();
  state().save.size = {1200, 900};
  rig.frame();
  rig.click("Save");
  ASSERT_TRUE(rig.content().picture_job().pending());
  ask();
  if (rig.content().picture_job().state()) {
    ASSERT_TRUE(shown("Quit when saved"));
    rig.click("Quit when saved");
  }
  ASSERT_TRUE(rig.frames_until([&] { return state().leaving.quit; }));
  EXPECT_FALSE(rig.content().picture_job().state().has_value());
  EXPECT_TRUE(std::filesystem::exists(folder.file("scene-001.png")));
}

// The message about a finished save appears without any input.
TEST_F(LeavingTest, AFinishedSaveIsShownThoughNobodyMoves) {
  rig.chord(Key::ctrl, Key::s);
  rig.frame();
  rig.click("Save");
  ASSERT_TRUE(rig.frames_until([&] { return rig.content().picture_job().pending(); }));
  ASSERT_TRUE(rig.sleeps());
  EXPECT_FALSE(shown("Stop saving"));
  EXPECT_FALSE(rig.content().picture_job().pending());
}

// The pixel panel is laid out completely without any input while its report is computed.
TEST_F(LeavingTest, APixelsPanelIsCompleteThoughNobodyMoves) {
  rig.set_blind(false);  // the drawn pixels are compared
  rig.set_pixel_size(1);
  EXPECT_TRUE(rig.settle());
  rig.move_to({170, 300});
  rig.input().add(KeyChanged{Key::ctrl, true});
  rig.press(MouseButton::left);
  rig.release(MouseButton::left);
  rig.input().add(KeyChanged{Key::ctrl, false});
  rig.move_to({2, 900});
  ASSERT_TRUE(rig.sleeps());
  const std::vector<glm::u8vec3> asleep = rig.pixels();
  EXPECT_TRUE(shown("Subdivision"));
  for (int i = 0; i < 5; ++i) rig.frame();
  EXPECT_EQ(rig.pixels(), asleep) << "nothing was left to be drawn";
}

}  // namespace
}  // namespace asos
