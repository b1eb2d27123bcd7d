#include "app/shutter_option.h"
#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/moving_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace asos::test::shutter_test {
namespace {

TEST(ParseShutter, TakesSecondsAndDegrees) {
  const auto seconds = parse_shutter("0.02");
  ASSERT_TRUE(seconds);
  EXPECT_EQ(seconds->value, 0.02);
  EXPECT_FALSE(seconds->degrees);
  const auto degrees = parse_shutter("180deg");
  ASSERT_TRUE(degrees);
  EXPECT_EQ(degrees->value, 180.0);
  EXPECT_TRUE(degrees->degrees);
  for (const char* wrong :
       {"", "-1", "-1deg", "361deg", "3601", "nan", "inf", "deg", "1s", "1 deg"})
    EXPECT_FALSE(parse_shutter(wrong)) << wrong;
  EXPECT_TRUE(contains(parse_shutter("-1").error().message(), "0 to 3600 seconds nor 0deg to 360"));
}

TEST(TakeShutter, RefersDegreesToTheFrame) {
  PictureArguments arguments;
  take_shutter(arguments, 24.0);
  EXPECT_EQ(arguments.settings.shutter.seconds, 0.0);
  arguments.shutter = ShutterChoice{180.0, true};
  take_shutter(arguments, 25.0);
  EXPECT_DOUBLE_EQ(arguments.settings.shutter.seconds, 0.02);
  arguments.shutter = ShutterChoice{0.5, false};
  take_shutter(arguments, 25.0);
  EXPECT_EQ(arguments.settings.shutter.seconds, 0.5);
}

/// A square that slides by four units in a second.
class Shutter : public testing::Test {
 protected:
  Shutter() {
    GltfBuilder b = GltfBuilder::square();
    add_channel(b, 0, "translation", b.scalars({0, 1}), b.vec3({{0, 0, 0}, {4, 0, 0}}));
    scene_ = folder_.write("slide.glb", b.glb());
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
  AsosRun render(const std::string& out, const std::vector<std::string>& words) {
    return run_asos(std::vector<std::string>{"render", scene_, "-o", path(out), "--size", "24x16",
                                             "--max", "2", "--look-at", "2,0.5,6,2,0.5,0"} +
                    words);
  }
  bool same(const std::string& a, const std::string& b) {
    return read_png(path(a)).value().rgb == read_png(path(b)).value().rgb;
  }

  TemporaryFolder folder_;
  std::string scene_;
};

TEST_F(Shutter, BlursAndIsKeptInPictures) {
  const std::vector<std::string> time{"--time", "0.5"};
  ASSERT_EQ(render("sharp.png", time).exit_code, 0);
  const AsosRun blurred = render("a.png", time + std::vector<std::string>{"--shutter", "0.25"});
  ASSERT_EQ(blurred.exit_code, 0) << blurred.err;
  EXPECT_EQ(blurred.err.find("shutter"), std::string::npos) << blurred.err;
  EXPECT_FALSE(same("sharp.png", "a.png"));
  EXPECT_EQ(read_description(path("a.png"))->settings.shutter.seconds, 0.25);
  const AsosRun again = run_asos({"render", "--from", path("a.png"), "-o", path("b.png")});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(same("a.png", "b.png"));
  ASSERT_EQ(run_asos({"render", "--from", path("a.png"), "-o", path("c.png"), "--shutter", "0"})
                .exit_code,
            0);
  EXPECT_TRUE(same("sharp.png", "c.png"));
  EXPECT_EQ(read_description(path("c.png"))->settings.shutter.seconds, 0.0);
}

TEST_F(Shutter, BlursEachFrameByItsDegrees) {
  ASSERT_EQ(render("run.png", {"--animation", "0", "--frames", "4-5/10", "--shutter", "180deg"})
                .exit_code,
            0);
  EXPECT_DOUBLE_EQ(read_description(path("run-0004.png"))->settings.shutter.seconds, 0.05);
  ASSERT_EQ(render("time.png", {"--time", "0.4", "--shutter", "0.05"}).exit_code, 0);
  EXPECT_TRUE(same("run-0004.png", "time.png"));
  EXPECT_FALSE(same("run-0004.png", "run-0005.png"));
}

TEST_F(Shutter, SaysWhatIsNotAsAsked) {
  const auto note = [&](const std::vector<std::string>& words) {
    const AsosRun run = render("note.png", words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.err;
  };
  EXPECT_TRUE(contains(note({"--shutter", "0.1"}), "opens before the animation begins"));
  EXPECT_TRUE(contains(note({"--time", "1", "--shutter", "0.1"}), "after the animation's end"));
  EXPECT_TRUE(contains(note({"--time", "3", "--shutter", "0.1"}), "nothing moves"));
  EXPECT_TRUE(contains(note({"--time", "0.5", "--shutter", "0.1", "--method", "beam"}),
                       "beam renders without motion blur"));
}

TEST_F(Shutter, IsNotTracedButNamed) {
  const auto trace = [&](const std::vector<std::string>& words) {
    const AsosRun run = run_asos(
        std::vector<std::string>{"trace", scene_, "--size", "24x16", "--pixel", "12,8"} + words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  };
  EXPECT_FALSE(contains(trace({}), "animation"));
  const std::string sharp = trace({"--time", "0.5"});
  EXPECT_TRUE(contains(sharp, ", animation 0 at 0.5 s\n")) << sharp;
  const std::string blurred = trace({"--time", "0.5", "--shutter", "0.25"});
  EXPECT_TRUE(contains(blurred,
                       "One moment of the exposure, its middle: the shutter is open from "
                       "0.375 to 0.625 s\n"))
      << blurred;
  const auto json = nlohmann::json::parse(trace({"--time", "0.5", "--shutter", "0.25", "--json"}));
  EXPECT_EQ(json.at("moment").at("seconds"), 0.5);
  EXPECT_EQ(json.at("moment").at("shutter"), 0.25);
  EXPECT_TRUE(nlohmann::json::parse(trace({"--json"})).at("moment").is_null());
}

TEST_F(Shutter, RefusesWhatCannotBe) {
  for (const char* wrong : {"-0.1", "3601", "400deg", "soon"}) {
    const AsosRun run = render("no.png", {"--time", "0.5", "--shutter", wrong});
    EXPECT_EQ(run.exit_code, 2) << wrong;
    EXPECT_TRUE(contains(run.err, "--shutter")) << wrong;
  }
  const AsosRun still =
      run_asos({"render", "builtin:boxes", "-o", path("no.png"), "--shutter", "0.1"});
  EXPECT_EQ(still.exit_code, 1);
  EXPECT_TRUE(contains(still.err, "has no animations, so --shutter has nothing to blur"));
  const AsosRun off = run_asos({"render", "builtin:boxes", "-o", path("off.png"), "--shutter", "0",
                                "--size", "16x9", "--max", "0"});
  EXPECT_EQ(off.exit_code, 0) << off.err;
}

}  // namespace
}  // namespace asos::test::shutter_test
