#include "app/command_line.h"

#include "renderer/gltf/load.h"
#include "renderer/kernels/instruction_set.h"
#include "renderer/scene/builtin.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace asos {
namespace {

using test::AsosRun;
using test::contains;
using test::run_asos;

TEST(CommandLine, VersionAndHelpSucceedOnStdout) {
  for (const char* word : {"--version", "--help", "-h", "--help-all"}) {
    const AsosRun outcome = run_asos({word});
    EXPECT_EQ(outcome.exit_code, 0) << word;
    EXPECT_TRUE(contains(outcome.out, "asos")) << word;
    EXPECT_EQ(outcome.err, "") << word;
  }
}

TEST(CommandLine, VersionNamesCommitAndFeatures) {
  const std::string version = run_asos({"--version"}).out;
  EXPECT_TRUE(version.starts_with("asos 1.0.0\ncommit: ")) << version;
  EXPECT_FALSE(contains(version, "commit: \n")) << version;
  const std::string set = std::string("instruction set: ") + instruction_set() + "\n";
  EXPECT_TRUE(contains(version, set)) << version;
  for (const char* feature : {"compiler: GCC", ".glb", "Draco", "meshopt", "WebP", ".hdr", "EXR"})
    EXPECT_TRUE(contains(version, feature)) << feature;
}

TEST(CommandLine, HelpNamesEveryCommand) {
  const AsosRun help = run_asos({"--help"});
  for (const char* command : {"view", "render", "info", "export-scene", "list-scenes"})
    EXPECT_TRUE(contains(help.out, command));
}

TEST(CommandLine, RenderHelpNamesEveryOption) {
  const AsosRun help = run_asos({"render", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option :
       {"SCENE",          "-o",          "--size",           "--method", "--max",
        "--eps",          "--spp",       "--leaf",           "--jitter", "--camera",
        "--look-at",      "--fov",       "--threads",        "--crop",   "--exposure",
        "--tone",         "--split-map", "--split-map-by",   "--stats",  "--contrast",
        "--depth",        "--spheres",   "--contrast-scale", "--quiet",  "Examples:",
        "--sky",          "--sky-turn",  "--background",     "--ground", "--tr",
        "--filter-width", "--time-limit"})
    EXPECT_TRUE(contains(help.out, option));
}

TEST(CommandLine, BadUsageIsNamedOnStderrWithExitCodeTwo) {
  const std::vector<std::vector<std::string>> cases{
      {"--no-such-option"},
      {"a.glb", "b.glb"},
      {"render"},
      {"render", "builtin:boxes"},
      {"render", "-o", "x.png"},
      {"render", "builtin:boxes", "-o", "x.jpg"},
      {"render", "builtin:boxes", "-o", "x"},
      {"render", "builtin:boxes", "-o"},
      {"render", "builtin:boxes", "-o", "x.png", "--split-map", "y.exr"},
      {"render", "builtin:boxes", "-o", "x.png", "--split-map", "./x.png"},
      {"render", "builtin:boxes", "-o", "x.png", "--split-map", "y.png", "--split-map-by", "depth"},
      {"render", "builtin:boxes", "-o", "x.png", "--split-map-by", "cause"},
      {"render", "builtin:boxes", "-o", "x.png", "--size", "0x0"},
      {"render", "builtin:boxes", "-o", "x.png", "--size", "1000000000x1000000000"},
      {"render", "builtin:boxes", "-o", "x.png", "--size", "-5x5"},
      {"render", "builtin:boxes", "-o", "x.png", "--method", "magic"},
      {"render", "builtin:boxes", "-o", "x.png", "--max", "9"},
      {"render", "builtin:boxes", "-o", "x.png", "--max", "-1"},
      {"render", "builtin:boxes", "-o", "x.png", "--max", "2.5"},
      {"render", "builtin:boxes", "-o", "x.png", "--eps", "nan"},
      {"render", "builtin:boxes", "-o", "x.png", "--eps", "-0.1"},
      {"render", "builtin:boxes", "-o", "x.png", "--eps", "0,1"},
      {"render", "builtin:boxes", "-o", "x.png", "--spp", "0"},
      {"render", "builtin:boxes", "-o", "x.png", "--contrast", "1.1"},
      {"render", "builtin:boxes", "-o", "x.png", "--contrast", "nan"},
      {"render", "builtin:boxes", "-o", "x.png", "--depth", "9"},
      {"render", "builtin:boxes", "-o", "x.png", "--depth", "-1"},
      {"render", "builtin:boxes", "-o", "x.png", "--contrast-scale", "-1"},
      {"render", "builtin:boxes", "-o", "x.png", "--contrast-scale", "4.5"},
      {"render", "builtin:boxes", "-o", "x.png", "--filter-width", "0.5"},
      {"render", "builtin:boxes", "-o", "x.png", "--filter-width", "nan"},
      {"render", "builtin:boxes", "-o", "x.png", "--leaf", "maple"},
      {"render", "builtin:boxes", "-o", "x.png", "--tr", "0"},
      {"render", "builtin:boxes", "-o", "x.png", "--tr", "9"},
      {"render", "builtin:boxes", "-o", "x.png", "--sky", "blue"},
      {"render", "builtin:boxes", "-o", "x.png", "--background", "colours"},
      {"render", "builtin:boxes", "-o", "x.png", "--background", "1,1,nan"},
      {"render", "builtin:boxes", "-o", "x.png", "--ground", "grass"},
      {"render", "builtin:boxes", "-o", "x.png", "--sky", "1,1,-1"},
      {"render", "builtin:boxes", "-o", "x.png", "--sky-turn", "nan"},
      {"render", "builtin:boxes", "-o", "x.png", "--threads", "-2"},
      {"render", "builtin:boxes", "-o", "x.png", "--threads", "1000000"},
      {"render", "builtin:boxes", "-o", "x.png", "--camera", "-1"},
      {"render", "builtin:boxes", "-o", "x.png", "--camera", "0", "--look-at", "1,1,1,0,0,0"},
      {"render", "builtin:boxes", "-o", "x.png", "--look-at", "1,1,1"},
      {"render", "builtin:boxes", "-o", "x.png", "--look-at", "1,1,1,1,1,1"},
      {"render", "builtin:boxes", "-o", "x.png", "--fov", "180"},
      {"render", "builtin:boxes", "-o", "x.png", "--fov", "0"},
      {"render", "builtin:boxes", "-o", "x.png", "--exposure", "inf"},
      {"render", "builtin:boxes", "-o", "x.png", "--crop", "0,0,0,5"},
      {"render", "builtin:boxes", "-o", "x.png", "--size", "64x36", "--crop", "60,0,5,5"},
      {"info"},
      {"info", "builtin:boxes", "--xml"},
      {"export-scene", "boxes"},
      {"export-scene", "boxes", "-o", "boxes.obj"},
      {"list-scenes", "more"},
  };
  for (const auto& words : cases) {
    const AsosRun outcome = run_asos(words);
    const std::string line = testing::PrintToString(words);
    EXPECT_EQ(outcome.exit_code, 2) << line << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_TRUE(contains(outcome.err, "asos")) << line;
    EXPECT_TRUE(contains(outcome.err, "--help")) << line;
  }
}

TEST(CommandLine, ABadValueIsQuotedWithWhatWouldBeRight) {
  const AsosRun outcome = run_asos({"render", "builtin:boxes", "-o", "x.png", "--max", "9"});
  EXPECT_TRUE(contains(outcome.err, "--max: \"9\": not a whole number from 0 to 8"));
}

TEST(CommandLine, BadInputIsNamedOnStderrWithExitCodeOne) {
  const test::TemporaryFolder folder;
  const std::string broken = (folder.path() / "broken.glb").string();
  std::ofstream(broken) << "this is no glTF";
  const std::string picture = (folder.path() / "x.png").string();
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"info", "no/such/file.glb"}, "no/such/file.glb: there is no such file"},
      {{"info", folder.path().string()}, "this is a directory"},
      {{"info", broken}, "broken.glb"},
      {{"info", ""}, "there is no such file"},
      {{"info", "builtin:ofice"}, "Did you mean builtin:office?"},
      {{"info", "ofice"}, "Did you mean builtin:office?"},
      {{"render", "boxes", "-o", picture}, "Did you mean builtin:boxes?"},
      {{"export-scene", "zzz", "-o", (folder.path() / "x.glb").string()}, "builtin:boxes"},
      {{"render", broken, "-o", picture}, "broken.glb"},
      {{"render", "builtin:boxes", "-o", "/no/such/folder/x.png"}, "cannot be written"},
      {{"render", "builtin:boxes", "-o", picture, "--stats", folder.path().string()},
       "it is a directory"},
      {{"render", "builtin:boxes", "-o", picture, "--size", "8x8", "--camera", "99"},
       "--camera 99"},
      {{"no/such/file.glb"}, "there is no such file"},
  };
  for (const auto& [words, message] : cases) {
    const AsosRun outcome = run_asos(words);
    const std::string line = testing::PrintToString(words);
    EXPECT_EQ(outcome.exit_code, 1) << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_TRUE(contains(outcome.err, message)) << line;
  }
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(CommandLine, WithoutADisplayTheWindowSaysHowToRender) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const AsosRun outcome = run_asos({"builtin:boxes", "--max", "2"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "asos render 'builtin:boxes' -o picture.png"));
}

TEST(CommandLine, ListScenesNamesEachBuiltinScene) {
  const AsosRun outcome = run_asos({"list-scenes"});
  EXPECT_EQ(outcome.exit_code, 0);
  ASSERT_FALSE(builtin_scenes().empty());
  for (const BuiltinScene& scene : builtin_scenes()) {
    EXPECT_TRUE(contains(outcome.out, "builtin:" + scene.name));
    EXPECT_TRUE(contains(outcome.out, scene.summary));
  }
}

TEST(CommandLine, AnExportedSceneHoldsWhatTheBuiltinOneDoes) {
  const test::TemporaryFolder folder;
  for (const char* name : {"boxes.glb", "boxes.gltf"}) {
    const std::string path = (folder.path() / name).string();
    const AsosRun exported = run_asos({"export-scene", "boxes", "-o", path});
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    const AsosRun original = run_asos({"info", "builtin:boxes", "--json"});
    const AsosRun copy = run_asos({"info", path, "--json"});
    ASSERT_EQ(copy.exit_code, 0) << copy.err;
    const auto a = nlohmann::json::parse(original.out);
    const auto b = nlohmann::json::parse(copy.out);
    for (const char* key : {"triangles", "instances", "lights", "warnings", "left_out"})
      EXPECT_EQ(a.at(key), b.at(key)) << key;
    EXPECT_EQ(a.at("cameras").size(), b.at("cameras").size());
    EXPECT_GT(a.at("triangles").get<int>(), 0);
  }
}

TEST(CommandLine, AnExportedSceneIsAnimated) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("pole.glb");
  const AsosRun exported = run_asos({"export-scene", "walking-pole", "-o", path});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_EQ(exported.err, "");
  EXPECT_TRUE(contains(run_asos({"info", path}).out, "1 animation is not played: 'walk'"));
}

TEST(CommandLine, InfoAnswersInTextToo) {
  const AsosRun outcome = run_asos({"info", "builtin:boxes"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* part :
       {"builtin:boxes", "triangles", "Bounds:", "Materials:", "Lights:", "Cameras:"})
    EXPECT_TRUE(contains(outcome.out, part));
}

}  // namespace
}  // namespace asos
