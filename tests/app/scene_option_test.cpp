#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace asos {
namespace {

using test::AsosRun;
using test::contains;
using test::GltfBuilder;
using test::run_asos;
using test::operator+;

/// --scene, for a file with two scenes: one square (the default) and two squares.
class SceneOption : public testing::Test {
 protected:
  SceneOption() {
    GltfBuilder b = GltfBuilder::square();
    b.json["nodes"].push_back({{"mesh", 0}, {"translation", {3, 0, 0}}});
    b.json["scenes"].push_back({{"nodes", {0, 1}}, {"name", "pair"}});
    file_ = folder_.write("scenes.glb", b.glb());
  }
  AsosRun render(const std::vector<std::string>& words, const std::string& to) {
    return run_asos(std::vector<std::string>{"render"} + words +
                    std::vector<std::string>{"-o", folder_.file(to)});
  }
  [[nodiscard]] RgbImage png(const std::string& name) {
    return read_png(folder_.file(name)).value();
  }
  [[nodiscard]] int number(const std::string& name) {
    return read_description(folder_.file(name)).value().scene_number;
  }

  test::TemporaryFolder folder_;
  std::string file_;
  const std::vector<std::string> small_{"--size", "32x18"};
};

TEST_F(SceneOption, ChoosesWhatIsRenderedWhichThePictureKeeps) {
  ASSERT_EQ(render({file_, "--size", "32x18"}, "own.png").exit_code, 0);
  ASSERT_EQ(render({file_, "--size", "32x18", "--scene", "0"}, "0.png").exit_code, 0);
  ASSERT_EQ(render({file_, "--size", "32x18", "--scene", "pair"}, "pair.png").exit_code, 0);
  EXPECT_TRUE(png("own.png").rgb == png("0.png").rgb);
  EXPECT_FALSE(png("own.png").rgb == png("pair.png").rgb);
  EXPECT_EQ(number("own.png"), -1);
  EXPECT_EQ(number("0.png"), -1);
  EXPECT_EQ(number("pair.png"), 1);
  const AsosRun again = render({"--from", folder_.file("pair.png")}, "again.png");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(png("pair.png").rgb == png("again.png").rgb);
  EXPECT_EQ(number("again.png"), 1);
  ASSERT_EQ(render({"--from", folder_.file("pair.png"), "--scene", "0"}, "back.png").exit_code, 0);
  EXPECT_EQ(number("back.png"), -1);
}

TEST_F(SceneOption, OnesThatThereAreNotAreNamed) {
  const AsosRun run = render({file_, "--scene", "2"}, "x.png");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "no scene '2'; there are 0, 1 ('pair')"));
  EXPECT_TRUE(contains(run.err, file_));
}

TEST_F(SceneOption, InfoListsThemAndDescribesOne) {
  const AsosRun own = run_asos({"info", file_});
  EXPECT_TRUE(contains(own.out,
                       "Scenes:     2\n  0: without a name, the one described here\n"
                       "  1: \"pair\"\n"));
  EXPECT_TRUE(contains(own.out, "in 1 instance of 1 mesh"));
  const AsosRun pair = run_asos({"info", file_, "--scene", "1"});
  EXPECT_TRUE(contains(pair.out, "  1: \"pair\", the one described here\n"));
  EXPECT_TRUE(contains(pair.out, "in 2 instances"));
  const auto told = nlohmann::json::parse(
      run_asos({"info", file_, "--scene", "pair", "--json"}).out, nullptr, false);
  EXPECT_EQ(told.at("shown_scene"), 1);
  EXPECT_EQ(told.at("default_scene"), 0);
}

}  // namespace
}  // namespace asos
