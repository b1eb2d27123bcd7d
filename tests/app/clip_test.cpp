#include "app/clip_choice.h"
#include "app/frame_list.h"
#include "app/progress_bar.h"
#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/moving_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>

namespace asos::test::clip_test {
namespace {

namespace fs = std::filesystem;

TEST(ParseClipFrames, TakesARangeOneOrAll) {
  const auto range = parse_clip_frames("10-19/29.97");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first, 10);
  EXPECT_EQ(range->last, 19);
  EXPECT_EQ(range->fps, 29.97);
  EXPECT_EQ(parse_clip_frames("7/24")->last, 7);
  EXPECT_EQ(parse_clip_frames("24")->first, 0);
  EXPECT_FALSE(parse_clip_frames("24")->last.has_value());
  for (const char* wrong : {"", "0", "1/0", "5-3/8", "-1/8", "1-/8", "a", "1/2/3", "1/-24", "nan",
                            "1/1001", "100001/24"})
    EXPECT_FALSE(parse_clip_frames(wrong)) << wrong;
}

TEST(FindAnimation, ByItsNameOrElseItsNumber) {
  SceneContents contents;
  for (const char* name : {"Walk", "0", ""}) contents.animations.push_back({name, 1.0, 1, 1});
  EXPECT_EQ(find_animation(contents, "f", std::nullopt), 0);
  EXPECT_EQ(find_animation(contents, "f", "Walk"), 0);
  EXPECT_EQ(find_animation(contents, "f", "0"), 1) << "its name";
  EXPECT_EQ(find_animation(contents, "f", "2"), 2);
  for (const char* wrong : {"Run", "3", "-1", "walk"}) {
    const auto none = find_animation(contents, "f", wrong);
    ASSERT_FALSE(none) << wrong;
    EXPECT_TRUE(contains(none.error().message(), "0 (\"Walk\"), 1 (\"0\"), 2"));
  }
  EXPECT_FALSE(find_animation({}, "f", std::nullopt));
}

TEST(Info, TellsOfAMoment) {
  const AsosRun rest = run_asos({"info", "builtin:walking-pole", "--json"});
  const AsosRun moved = run_asos({"info", "builtin:walking-pole", "--json", "--time", "10"});
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  ASSERT_EQ(moved.exit_code, 0) << moved.err;
  const auto before = nlohmann::json::parse(rest.out), after = nlohmann::json::parse(moved.out);
  EXPECT_FALSE(before.contains("time"));
  EXPECT_EQ(after.at("time").at("seconds"), 10.0);
  EXPECT_FALSE(before.at("not_shown").empty());
  EXPECT_TRUE(after.at("not_shown").empty());
  EXPECT_TRUE(contains(run_asos({"info", "builtin:walking-pole", "--time", "2"}).out,
                       "Moment:     2 s of animation 0"));
  const AsosRun none = run_asos({"info", "builtin:boxes", "--time", "1"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_TRUE(contains(none.err, "has no animations"));
}

TEST(FramesOfAClip, EndWithIt) {
  SceneContents contents{.animations = {{"a", 1.0, 1, 1}}};
  RenderArguments arguments{.output = "d/a.png", .clip_frames = ClipFrames{0, std::nullopt, 24.0}};
  const ClipTime start{0, 0.0};
  const auto frames = frames_of(arguments, contents, start);
  ASSERT_EQ(frames.size(), 25u);
  EXPECT_EQ(frames[24].time->seconds, 1.0);
  EXPECT_EQ(arguments_of(arguments, frames[24]).output, "d/a-0024.png");
  EXPECT_EQ(beyond_the_end(frames, contents), 0u);
  arguments.clip_frames->last = 30;
  EXPECT_EQ(beyond_the_end(frames_of(arguments, contents, start), contents), 6u);
  arguments.clip_frames = ClipFrames{26, std::nullopt, 24.0};
  EXPECT_TRUE(frames_of(arguments, contents, start).empty());
}

TEST(ProgressOfAll, CountsThePicturesAndTheirTime) {
  Progress now{.fraction = 0.5, .seconds = 2.0, .seconds_left = 2.0};
  // One of four pictures existed, one took 8 s, and this one will take 4 s: 6 s remain for the last
  // one.
  const Progress all = progress_of_all(now, {4, 2, 1, 8.0});
  EXPECT_DOUBLE_EQ(all.fraction, 2.5 / 4);
  EXPECT_DOUBLE_EQ(all.seconds_left, 2.0 + 6.0);
  // A picture without an estimate is assumed to take as long as those before; for the first one
  // nothing is known.
  now.seconds_left = -1.0;
  EXPECT_DOUBLE_EQ(progress_of_all(now, {3, 1, 1, 8.0}).seconds_left, 6.0 + 8.0);
  EXPECT_LT(progress_of_all(now, {3, 0, 0, 0.0}).seconds_left, 0.0);
  now.seconds_left = 1.0;
  EXPECT_DOUBLE_EQ(progress_of_all(now, {}).seconds_left, 1.0);
}

/// A square that moves by one unit to the right in one second (animation "Slide"), and an animation
/// that does nothing.
class Clip : public testing::Test {
 protected:
  Clip() {
    GltfBuilder b = GltfBuilder::square();
    add_channel(b, 0, "translation", b.scalars({0, 1}), b.vec3({{0, 0, 0}, {1, 0, 0}}));
    b.json["animations"][0]["name"] = "Slide";
    scene_ = folder_.write("slide.glb", b.glb());
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
  AsosRun render(const std::string& out, const std::vector<std::string>& words) {
    return run_asos(std::vector<std::string>{"render", scene_, "-o", path(out), "--size", "24x16",
                                             "--max", "2"} +
                    words);
  }
  RgbImage png(const std::string& name) { return read_png(path(name)).value(); }
  bool same(const std::string& a, const std::string& b) { return png(a).rgb == png(b).rgb; }
  fs::file_time_type written(const std::string& name) { return fs::last_write_time(path(name)); }
  /// Sets a file's time to one hour ago, so that a rewrite shows.
  void age(const std::string& file) {
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  }

  TemporaryFolder folder_;
  std::string scene_;
};

TEST_F(Clip, AFrameAloneIsThatOfTheRunBitForBit) {
  ASSERT_EQ(render("run.png", {"--animation", "Slide", "--frames", "2-5/10"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("run-0001.png")));
  EXPECT_FALSE(fs::exists(path("run-0006.png")));
  ASSERT_EQ(render("alone.png", {"--animation", "0", "--frames", "4/10"}).exit_code, 0);
  ASSERT_EQ(render("time.png", {"--time", "0.4"}).exit_code, 0);
  EXPECT_TRUE(same("run-0004.png", "alone-0004.png"));
  EXPECT_TRUE(same("run-0004.png", "time.png"));
  EXPECT_FALSE(same("run-0004.png", "run-0005.png"));
  // The file has no lights; its default lighting is that of the scene at rest.
  const std::vector<std::string> look{"--look-at", "0.5,0.5,4,0.5,0.5,0"};
  ASSERT_EQ(render("rest.png", look).exit_code, 0);
  ASSERT_EQ(render("start.png", look + std::vector<std::string>{"--time", "0"}).exit_code, 0);
  EXPECT_TRUE(same("rest.png", "start.png"));
}

// The default camera stands still and frames the whole movement.
TEST_F(Clip, TheWholeAnimationIsFramed) {
  ASSERT_EQ(render("s.png", {"--animation", "Slide", "--frames", "2"}).exit_code, 0);
  const PictureDescription first = read_description(path("s-0000.png")).value();
  const PictureDescription last = read_description(path("s-0002.png")).value();
  EXPECT_EQ(first.camera.world_from_camera, last.camera.world_from_camera);
  EXPECT_EQ(first.origin, last.origin);
  const glm::dmat4 camera_from_world = glm::inverse(first.camera.world_from_camera);
  const double down = std::tan(0.5 * first.camera.fov_y_rad), across = down * 24 / 16;
  for (const double x : {0.0, 2.0}) {  // the left border at first, the right one at last
    for (const double y : {0.0, 1.0}) {
      const glm::dvec4 p = camera_from_world * glm::dvec4(glm::dvec3(x, y, 0.0) - first.origin, 1);
      EXPECT_LT(std::abs(p.x), -p.z * across) << x << " " << y;
      EXPECT_LT(std::abs(p.y), -p.z * down) << x << " " << y;
    }
  }
}

TEST_F(Clip, PicturesKeepTheirTime) {
  ASSERT_EQ(render("a.png", {"--time", "0.25"}).exit_code, 0);
  const auto said = read_description(path("a.png"));
  ASSERT_TRUE(said) << said.error().message();
  EXPECT_EQ(said->time, (ClipTime{0, 0.25}));
  const auto again = [&](const std::string& out, std::vector<std::string> words) {
    return run_asos(std::vector<std::string>{"render", "--from", path("a.png"), "-o", path(out)} +
                    words);
  };
  ASSERT_EQ(again("b.png", {}).exit_code, 0);
  EXPECT_TRUE(same("a.png", "b.png"));
  ASSERT_EQ(again("c.png", {"--time", "0.75"}).exit_code, 0);
  EXPECT_EQ(read_description(path("c.png"))->time, (ClipTime{0, 0.75}));
  EXPECT_FALSE(same("a.png", "c.png"));
}

TEST_F(Clip, GoesOnWhereItStopped) {
  const std::vector<std::string> words{"--animation", "Slide", "--frames", "0-3/4"};
  ASSERT_EQ(render("run.png", words).exit_code, 0);
  const RgbImage third = png("run-0002.png");
  fs::remove(path("run-0002.png"));
  const auto first_written = written("run-0001.png");
  const AsosRun again = render("run.png", words);
  ASSERT_EQ(again.exit_code, 0);
  EXPECT_TRUE(contains(again.out, "Kept " + path("run-0001.png")));
  EXPECT_TRUE(contains(again.out, "Wrote " + path("run-0002.png")));
  EXPECT_EQ(written("run-0001.png"), first_written);
  EXPECT_EQ(png("run-0002.png").rgb, third.rgb);

  // Renders again if settings differ, the file is broken or older than the scene, or its render was
  // stopped.
  ASSERT_EQ(render("run.png", words + std::vector<std::string>{"--eps", "0.5"}).exit_code, 0);
  EXPECT_EQ(read_description(path("run-0003.png"))->settings.asos.eps, 0.5);
  std::ofstream(path("run-0001.png")) << "no picture";
  EXPECT_TRUE(contains(render("run.png", words).out, "Wrote " + path("run-0001.png")));
  age(path("run-0000.png"));
  age(path("run-0000.png"));
  EXPECT_TRUE(contains(render("run.png", words).out, "Wrote " + path("run-0000.png")));
  EXPECT_TRUE(contains(render("run.png", words).out, "Kept " + path("run-0000.png")));
  const auto with_map = [&](const char* by) {
    const std::vector<std::string> map{"--split-map", path("map.png"), "--split-map-by", by};
    return render("run.png", words + map).out;
  };
  EXPECT_TRUE(contains(with_map("level"), "Wrote " + path("run-0000.png")))
      << "there is no map yet";
  EXPECT_TRUE(contains(with_map("level"), "Kept " + path("run-0000.png")));
  EXPECT_TRUE(contains(with_map("cause"), "Wrote " + path("run-0000.png")));
}

TEST_F(Clip, APictureThatALimitOfTimeStoppedIsNotKept) {
  const std::vector<std::string> words{
      "render", scene_,        "-o",    path("s.png"), "--size", "400x300",      "--max",
      "5",      "--animation", "Slide", "--frames",    "0-1/2",  "--time-limit", "0"};
  ASSERT_EQ(run_asos(words).exit_code, 0);
  const ImageText text = read_image_text(path("s-0000.png")).value();
  const auto stats =
      std::ranges::find(text, "asos.statistics", [](const auto& t) { return t.first; });
  ASSERT_FALSE(nlohmann::json::parse(stats->second)["time_limit"]["finished"].get<bool>())
      << "this machine is too fast for the test";
  EXPECT_TRUE(contains(run_asos(words).out, "Wrote " + path("s-0000.png")));
}

TEST_F(Clip, SaysWhatCannotBe) {
  const auto refused = [&](const std::vector<std::string>& words, int code, const char* why) {
    const AsosRun run = render("x.png", words);
    EXPECT_EQ(run.exit_code, code) << why;
    EXPECT_TRUE(contains(run.err, why));
    EXPECT_FALSE(fs::exists(path("x.png")));
  };
  refused({"--animation", "Run"}, 1, "has no animation \"Run\"; there is 0 (\"Slide\")");
  refused({"--time", "-1"}, 2, "--time");
  refused({"--time", "nan"}, 2, "--time");
  refused({"--animation", "Slide", "--time", "1", "--frames", "0-3/4"}, 2, "--time");
  refused({"--animation", "Slide", "--frames", "3"}, 0, "");
  refused({"--animation", "Slide", "--frames", "a"}, 2, "--frames");
  const AsosRun still = run_asos({"render", "builtin:boxes", "-o", path("x.png"), "--time", "1"});
  EXPECT_EQ(still.exit_code, 1);
  EXPECT_TRUE(contains(still.err, "has no animations"));
}

TEST_F(Clip, SaysWhatIsNotShownUnlessItIsQuiet) {
  const char* not_played = "asos: warning: 1 animation is not played: 'Slide'; everything stands";
  EXPECT_TRUE(contains(render("a.png", {"--stats", path("a.json")}).err, not_played));
  EXPECT_EQ(render("a.png", {"--time", "0"}).err, "");
  EXPECT_TRUE(contains(render("a.png", {"--time", "1.5"}).err, "after the animation's end"));
  EXPECT_EQ(render("a.png", {"--quiet"}).err, "");
  std::ifstream file(path("a.json"));
  const auto stats = nlohmann::json::parse(file);
  EXPECT_TRUE(contains(stats.at("warnings").dump(), "1 animation is not played"));
}

/// A square that an animation hides from 0.9 s on.
class Vanishing : public testing::Test {
 protected:
  Vanishing() {
    GltfBuilder b = GltfBuilder::square();
    b.json["extensionsUsed"] = {"KHR_node_visibility", "KHR_animation_pointer"};
    b.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = true;
    add_channel(b, 0, "pointer", b.scalars({0.0f, 0.9f}),
                b.accessor(b.view(std::vector<std::uint8_t>{1, 0}), 5121, "SCALAR", 2), "STEP");
    nlohmann::json& target = b.json["animations"][0]["channels"].back()["target"];
    target.erase("node");
    target["extensions"]["KHR_animation_pointer"]["pointer"] =
        "/nodes/0/extensions/KHR_node_visibility/visible";
    scene_ = folder_.write("vanishing.glb", b.glb());
  }
  [[nodiscard]] AsosRun render(const std::vector<std::string>& words) const {
    return run_asos(std::vector<std::string>{"render", scene_, "-o", folder_.file("v.png"),
                                             "--size", "16x16", "--max", "1", "--sky", "0,0,0",
                                             "--background", "0,0,1"} +
                    words);
  }
  /// The number of pixels that are not of the background's colour.
  [[nodiscard]] int shown(const std::string& name) const {
    const RgbImage picture = read_png(folder_.file(name)).value();
    int count = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
      count += !(picture.rgb[i] == picture.rgb[0] && picture.rgb[i + 2] == picture.rgb[2]);
    return count;
  }

  TemporaryFolder folder_;
  std::string scene_;
};

TEST_F(Vanishing, FramesGoOnWhereNothingIsVisible) {
  const AsosRun run = render({"--animation", "0", "--frames", "20-23/24"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(shown("v-0021.png"), 0);
  EXPECT_EQ(shown("v-0022.png"), 0);
  EXPECT_EQ(shown("v-0023.png"), 0);
  EXPECT_TRUE(contains(run.err, "nothing is visible at 0.9167 s"));
  EXPECT_TRUE(contains(run.err, "nothing is visible at 0.9583 s"));
  EXPECT_FALSE(contains(run.err, "0.875 s"));
}

TEST_F(Vanishing, ExposureMayHaveAnEmptyMiddle) {
  const AsosRun run = render({"--time", "1", "--shutter", "0.5"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GT(shown("v.png"), 0) << "the square is visible for 0.15 of 0.5 s";
  EXPECT_FALSE(contains(run.err, "nothing is visible"));
}

TEST_F(Clip, APixelIsTracedAtItsTime) {
  const auto traced = [&](const char* time) {
    return run_asos({"trace", scene_, "--size", "24x16", "--pixel", "12,8", "--json", "--look-at",
                     "0.5,0.5,4,0.5,0.5,0", "--time", time})
        .out;
  };
  ASSERT_FALSE(nlohmann::json::parse(traced("0"), nullptr, false).is_discarded());
  EXPECT_NE(traced("0"), traced("1")) << "the square has left";
  EXPECT_EQ(traced("1"), traced("1"));
}

TEST_F(Clip, InfoListsWhatMoves) {
  const AsosRun run = run_asos({"info", scene_});
  EXPECT_TRUE(contains(run.out, "Animations: 1\n  0: \"Slide\", 1 s, 1 channel\n"));
  EXPECT_TRUE(contains(run.out, "Not shown:  1 animation is not played: 'Slide'"));
  const auto json = nlohmann::json::parse(run_asos({"info", scene_, "--json"}).out);
  EXPECT_EQ(json.at("animations").at(0).at("seconds"), 1.0);
  EXPECT_EQ(json.at("animations").at(0).at("channels"), 1);
  EXPECT_TRUE(json.at("skins").empty());
}

}  // namespace
}  // namespace asos::test::clip_test
