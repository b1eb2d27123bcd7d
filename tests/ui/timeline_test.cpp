#include "renderer/picture/picture_text.h"
#include "tests/ui/sliding_file.h"
#include "tests/ui/test_scenes.h"
#include "tests/ui/ui_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace asos::test::timeline_test {
using namespace ui;
namespace {

/// The sliding square, with a line next to it that moves along.
GltfBuilder sliding_line() {
  GltfBuilder b = sliding();
  b.primitive({{"POSITION", b.vec3({{0, -0.2f, 0}, {1, -0.3f, 0}})}})["mode"] = 1;
  return b;
}

/// The sliding square, with another one above that stands still.
GltfBuilder two_squares() {
  GltfBuilder b = sliding();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 2, 0}}});
  b.json["scenes"][0]["nodes"].push_back(3);
  return b;
}

/// The sliding square with one of its animations.
GltfBuilder one_clip() {
  GltfBuilder b = sliding();
  b.json["animations"].erase(1);
  return b;
}

class Timeline : public testing::Test {
 protected:
  Timeline() {
    rig.set_pixel_size(3);
    rig.settings().asos.max_level = 1;
    open("moving");
  }
  void open(const std::string& source) {
    const std::uint64_t opened = rig.scene().times_opened();
    rig.scene().open(source);
    EXPECT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
    EXPECT_TRUE(rig.settle());
  }
  OpenScene& scene() { return rig.scene(); }
  Playback& playback() { return rig.previewer().playback(); }
  [[nodiscard]] bool has(const std::string& control) { return rig.controls().contains(control); }
  /// Draws frames until the picture of the requested time is finished.
  void arrive() {
    EXPECT_TRUE(rig.frames_until([&] { return !playback().posing(); }));
    EXPECT_TRUE(rig.settle());
    EXPECT_EQ(scene()->geometry->time, playback().time());
  }
  void seek(double seconds) {
    playback().seek(seconds);
    arrive();
  }
  /// Position of the square's first corner, in the author's coordinates.
  double corner_x() {
    const World& world = scene()->world();
    return world.origin.x + static_cast<double>(world.parts.at(0).bounds.lo.x);
  }
  std::vector<glm::vec3> picture() { return rig.film().radiance; }

  UiRig rig{[](const std::string& source) -> Result<Scene> {
              if (source == "lines") return with_rig(sliding_line());
              if (source == "one clip") return with_rig(one_clip());
              if (source == "two") return with_rig(two_squares());
              if (source == "still") return two_triangles({1, 0, 0}, source);
              return with_rig(sliding());
            },
            {660, 700}};
};

TEST_F(Timeline, IsThereOnlyWhereSomethingMoves) {
  for (const char* name : {"Clip", "Play", "Frame >", "< Frame", "Loop", "Speed", "Frames/s"}) {
    EXPECT_TRUE(rig.control(name).has_tooltip) << name;
  }
  EXPECT_FALSE(has("Time")) << "at rest there is no time";
  EXPECT_FALSE(notes_of(*scene()).not_shown.empty());
  EXPECT_FALSE(has("section/Warnings")) << "the controls show that it can be played";
  open("still");
  EXPECT_FALSE(has("Clip"));
  EXPECT_FALSE(has("section/Animation"));
  playback().set_playing(true);
  playback().seek(1.0);
  EXPECT_FALSE(playback().playing());
  EXPECT_FALSE(playback().time().has_value());
}

TEST_F(Timeline, TheOnlyAnimationOfAFilePlaysWhenItIsOpened) {
  EXPECT_FALSE(playback().playing()) << "unless the program asks for it";
  playback().options().plays_at_first = true;
  const auto opens = [&](const std::string& source) {
    const std::uint64_t opened = scene().times_opened();
    scene().open(source);
    EXPECT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
  };
  opens("moving");
  EXPECT_FALSE(playback().playing()) << "one of several has to be chosen";
  opens("one clip");
  ASSERT_EQ(playback().animations().size(), 1u);
  const bool fast = scene()->geometry->build_seconds * Playback::least_poses < 1.0;
  EXPECT_EQ(playback().playing(), fast);
  playback().set_playing(false);
  const std::uint64_t opened = scene().times_opened();
  scene().reload();
  EXPECT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
  EXPECT_FALSE(playback().playing()) << "a reload keeps the pause";
}

TEST_F(Timeline, ShowsTheMomentThatIsSoughtAndTheSameAgain) {
  const std::vector<glm::vec3> rest = picture();
  seek(0.5);
  EXPECT_NEAR(corner_x(), 1.0, 1e-5);
  const std::vector<glm::vec3> half = picture();
  EXPECT_NE(half, rest);
  const Controls::Placed slider = rig.control("Time");
  rig.drag(slider.centre(), {slider.hi.x + 100.0f, slider.centre().y});
  EXPECT_DOUBLE_EQ(playback().time()->seconds, 2.0);
  arrive();
  EXPECT_NEAR(corner_x(), 2.0, 1e-5);
  seek(0.5);
  EXPECT_EQ(picture(), half) << "independently of other times before";
  playback().choose(-1);
  arrive();
  EXPECT_EQ(picture(), rest);
  EXPECT_NEAR(corner_x(), 0.0, 1e-5);
}

// The row is under the picture; in a small window its controls are in the panel.
TEST_F(Timeline, StandsUnderThePictureAndPlaysBySpace) {
  for (int i = 0; i < 2; ++i) rig.frame();
  const auto& all = rig.controls();
  const WindowLayout& layout = rig.content().layout();
  ASSERT_GT(layout.timeline.size.y, 0.0f);
  EXPECT_EQ(layout.timeline.lo.y, layout.picture.lo.y + layout.picture.size.y);
  ASSERT_TRUE(has("Play on picture"));
  EXPECT_GT(all.at("Play").lo.y, layout.timeline.lo.y);
  rig.click("Play on picture");
  EXPECT_TRUE(playback().playing());
  for (int i = 0; i < 2; ++i) rig.frame();
  EXPECT_FALSE(has("Play on picture")) << "it has been played";
  rig.key(Key::space);
  EXPECT_FALSE(playback().playing());
  EXPECT_FALSE(rig.refinement().paused()) << "Space is the clip's";
  arrive();
  ASSERT_TRUE(has("Time"));
  EXPECT_LT(all.at("Time").hi.x, layout.panel.lo.x);
  rig.key(Key::space);
  EXPECT_TRUE(playback().playing());
  rig.key(Key::space);
  open("still");
  for (int i = 0; i < 2; ++i) rig.frame();
  EXPECT_EQ(layout.timeline.size.y, 0.0f);
  rig.key(Key::space);
  EXPECT_TRUE(rig.refinement().paused());
}

TEST_F(Timeline, PlaysAndRefinesWhenItPauses) {
  rig.click("Play");
  ASSERT_TRUE(playback().playing());
  std::set<double> moments;
  EXPECT_TRUE(rig.frames_until([&] {
    if (scene()->geometry->time) moments.insert(scene()->geometry->time->seconds);
    return moments.size() >= 4;
  }));
  rig.click("Pause clip");
  ASSERT_FALSE(playback().playing());
  const double seconds = playback().time()->seconds;
  arrive();
  EXPECT_EQ(playback().time()->seconds, seconds);
  EXPECT_TRUE(rig.render().progress().finished);
  EXPECT_TRUE(rig.sleeps()) << "a paused window is idle";
}

/// Start of the drawn line, in the author's coordinates.
double line_x(const World& world) {
  const LinesAndPoints& lines_and_points = world.lines_and_points;
  float least = std::numeric_limits<float>::infinity();
  for (std::uint32_t i = 0; i < lines_and_points.vertex_count; ++i)
    least = std::min(least, world.positions[lines_and_points.first_vertex + i].x);
  return world.origin.x + static_cast<double>(least);
}

TEST_F(Timeline, LinesAreDrawnAtEveryMomentThatPlays) {
  open("lines");
  ASSERT_TRUE(rig.frames_until([&] { return scene()->world().lines_and_points.drawn(); }));
  playback().choose(0);
  playback().set_playing(true);
  std::set<double> moments;
  EXPECT_TRUE(rig.frames_until([&] {
    if (!scene()->geometry->time) return false;
    moments.insert(scene()->geometry->time->seconds);
    EXPECT_TRUE(scene()->world().lines_and_points.drawn());
    EXPECT_NEAR(line_x(scene()->world()), corner_x(), 0.05);
    return moments.size() >= 4;
  }));
  playback().set_playing(false);
  seek(1.0);
  const std::vector<glm::vec3> sought = picture();
  EXPECT_NEAR(line_x(scene()->world()), 2.0, 0.05);
  // After the camera's animation was chosen, the first one gives the same picture again.
  playback().choose(1);
  seek(0.5);
  playback().choose(0);
  seek(1.0);
  EXPECT_EQ(picture(), sought);
}

TEST_F(Timeline, OpensAtTheMomentThatIsAskedFor) {
  const auto open_at = [&](const ClipChoice& clip) {
    const std::uint64_t opened = scene().times_opened();
    scene().open(SceneSource{"moving", "", "", clip});
    EXPECT_TRUE(rig.frames_until(
        [&] { return scene().times_opened() > opened || scene().error().has_value(); }));
    EXPECT_TRUE(rig.settle());
  };
  open_at({"Slide", 0.5});
  EXPECT_EQ(playback().time(), (ClipTime{0, 0.5}));
  EXPECT_NEAR(corner_x(), 1.0, 1e-5);
  open_at({"Dolly", std::nullopt});
  EXPECT_EQ(playback().time(), (ClipTime{1, 0.0}));
  open_at({"Jump", 0.5});
  ASSERT_TRUE(scene().error());
  EXPECT_NE(scene().error()->message().find("no animation \"Jump\""), std::string::npos);
}

TEST_F(Timeline, EndsOrBeginsAgain) {
  playback().options() = {false, 4.0, 24.0};
  playback().set_playing(true);
  EXPECT_TRUE(rig.frames_until([&] { return !playback().playing(); }));
  EXPECT_DOUBLE_EQ(playback().time()->seconds, 2.0);
  // At its end, the animation restarts.
  playback().set_playing(true);
  EXPECT_EQ(playback().time()->seconds, 0.0);
  playback().options().loop = true;
  double before = 0.0;
  EXPECT_TRUE(rig.frames_until([&] {
    const double now = playback().time()->seconds;
    const bool again = now < before;
    before = now;
    return again;
  }));
  EXPECT_TRUE(playback().playing());
  EXPECT_LT(before, 2.0);
}

TEST_F(Timeline, StepsByWholeFrames) {
  playback().seek(0.05);  // between the first and the second frame at 24 per second
  arrive();
  rig.click("Frame >");
  EXPECT_DOUBLE_EQ(playback().time()->seconds, 2.0 / 24);
  rig.click("Frame >");
  EXPECT_DOUBLE_EQ(playback().time()->seconds, 3.0 / 24);
  rig.click("< Frame");
  EXPECT_DOUBLE_EQ(playback().time()->seconds, 2.0 / 24);
  playback().step(-9);
  EXPECT_EQ(playback().time()->seconds, 0.0);
  playback().step(1000);
  EXPECT_EQ(playback().time()->seconds, 2.0);
  EXPECT_FALSE(playback().playing());
}

TEST_F(Timeline, TheCameraThatIsLookedThroughMovesWithIt) {
  playback().choose(1);
  seek(0.5);
  const auto eye_x = [&] {
    return rig.camera().camera().world_from_camera[3].x + scene()->world().origin.x;
  };
  EXPECT_NEAR(eye_x(), 1.0, 1e-6);
  EXPECT_FALSE(rig.viewpoint().left_chosen());
  // A camera that the user has moved stays.
  rig.viewpoint().frame_all();
  const double there = eye_x();
  seek(1.0);
  EXPECT_EQ(eye_x(), there);
}

TEST_F(Timeline, BlursMotionOfThePauseAndSavesIt) {
  seek(1.0);
  const std::vector<glm::vec3> sharp = picture();
  EXPECT_FALSE(has("Shutter"));
  rig.click("Motion blur");
  RenderSettings& settings = rig.settings();
  EXPECT_DOUBLE_EQ(settings.shutter.seconds, 0.5 / 24.0);
  EXPECT_TRUE(rig.control("Shutter").has_tooltip);
  settings.shutter.seconds = 0.5;
  rig.frame();
  arrive();
  ASSERT_TRUE(playback().exposure() && playback().exposure()->moves());
  EXPECT_EQ(playback().exposure()->shutter.seconds, 0.5);
  const std::vector<glm::vec3> blurred = picture();
  EXPECT_NE(blurred, sharp);
  EXPECT_TRUE(rig.sleeps());
  const PictureDescription said = rig.render().description({});
  EXPECT_EQ(said.settings.shutter.seconds, 0.5);

  rig.click("Motion blur");
  EXPECT_TRUE(rig.settle());
  EXPECT_EQ(picture(), sharp);
  const TemporaryFolder folder;
  ASSERT_TRUE(write_png(folder.file("blur.png"), rig.film(), {}, picture_text(said)));
  open(folder.file("blur.png"));
  rig.frame();
  arrive();
  EXPECT_EQ(rig.settings().shutter.seconds, 0.5);
  EXPECT_EQ(picture(), blurred);
}

TEST_F(Timeline, BlursTheMotionOfTheCameraThatIsLookedThrough) {
  playback().choose(1);
  seek(0.5);
  rig.settings().shutter.seconds = 0.5;
  rig.frame();
  arrive();
  ASSERT_TRUE(playback().exposure() && playback().exposure()->moves());
  EXPECT_EQ(rig.render().settings().shutter.camera, 0);
  // A camera moved by hand stands still.
  rig.viewpoint().frame_all();
  rig.frame();
  EXPECT_TRUE(rig.settle());
  EXPECT_EQ(rig.render().settings().shutter.camera, -1);
}

TEST_F(Timeline, EditsOfLightsLast) {
  ASSERT_EQ(scene()->lights().size(), 1u);
  rig.edits().edit_lights().at(0).light.intensity = 7.0f;
  EXPECT_TRUE(rig.settle());
  EXPECT_EQ(scene()->lights().at(0).intensity, 7.0f);
  seek(0.25);
  EXPECT_EQ(scene()->lights().at(0).intensity, 7.0f);
  rig.edits().reset_lights();
  EXPECT_TRUE(rig.settle());
  EXPECT_EQ(scene()->lights().at(0).intensity, 30.0f);
}

TEST_F(Timeline, WhatIsLeftMovesOnWhenSomethingIsHidden) {
  open("two");
  ASSERT_EQ(scene()->world().parts.size(), 2u);
  const std::uint64_t opened = scene().times_opened();
  scene().hide(1);
  ASSERT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
  ASSERT_EQ(scene()->world().parts.size(), 1u);
  const double from = corner_x();
  ASSERT_TRUE(playback().available());
  for (const double seconds : {0.5, 1.0}) {
    seek(seconds);
    EXPECT_EQ(scene()->world().parts.size(), 1u) << "it stays hidden";
    EXPECT_NEAR(corner_x(), from + 2.0 * seconds, 1e-6);
  }
}

TEST_F(Timeline, PicturesSayTheirMoment) {
  EXPECT_FALSE(rig.render().description({}).time.has_value());
  seek(0.75);
  EXPECT_EQ(rig.render().description({}).time, (ClipTime{0, 0.75}));
}

TEST_F(Timeline, ASavedPictureBringsItsMomentBack) {
  seek(0.5);
  const std::vector<glm::vec3> half = picture();
  const PictureDescription said = rig.render().description({});
  const TemporaryFolder folder;
  ASSERT_TRUE(write_png(folder.file("half.png"), rig.film(), {}, picture_text(said)));
  open("still");
  open(folder.file("half.png"));
  EXPECT_EQ(playback().time(), (ClipTime{0, 0.5}));
  arrive();
  EXPECT_NEAR(corner_x(), 1.0, 1e-5);
  EXPECT_EQ(picture(), half);
  seek(1.0);
  EXPECT_NEAR(corner_x(), 2.0, 1e-5) << "it can be played on from there";
}

TEST_F(Timeline, ReloadingKeepsTheMoment) {
  seek(0.5);
  const std::uint64_t opened = scene().times_opened();
  scene().reload();
  EXPECT_TRUE(rig.frames_until([&] { return scene().times_opened() > opened; }));
  arrive();
  EXPECT_EQ(playback().time(), (ClipTime{0, 0.5}));
  EXPECT_NEAR(corner_x(), 1.0, 1e-5);
}

}  // namespace
}  // namespace asos::test::timeline_test
