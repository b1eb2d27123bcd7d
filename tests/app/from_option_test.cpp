#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/support/temporary_folder.h"
#include "ui/display_settings.h"
#include "ui/previewer.h"
#include "ui/screenshot.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <thread>

namespace asos {
namespace {

using test::AsosRun;
using test::contains;
using test::run_asos;
using test::operator+;
using ui::DisplaySettings;
using ui::Previewer;

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

class FromOption : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
  AsosRun render(const std::vector<std::string>& words, const std::string& to) {
    return run_asos(std::vector<std::string>{"render"} + words +
                    std::vector<std::string>{"-o", path(to)});
  }
  RgbImage png(const std::string& name) { return read_png(path(name)).value(); }
  PictureDescription said(const std::string& name) { return read_description(path(name)).value(); }
  void expect_same(const std::string& a, const std::string& b) {
    EXPECT_EQ(png(a).width, png(b).width);
    EXPECT_TRUE(png(a).rgb == png(b).rgb) << a << " and " << b;
    EXPECT_EQ(description_text(said(a)), description_text(said(b)));
  }

  const std::vector<std::string> odd_ = words(
      "builtin:boxes --size 48x27 --max 2 --eps 0.0371 --exposure 0.7 --jitter --tr 2 "
      "--sky 0.1,0.3,1:0.7,0.6,0.5 --look-at 7,5,9,0,1,0 --fov 41.7 --dfr 0.1,1,32 "
      "--crop 5,3,35,20");
  test::TemporaryFolder folder_;
};

TEST_F(FromOption, GivesTheSamePictureBitForBit) {
  ASSERT_EQ(render(odd_, "a.png").exit_code, 0);
  ASSERT_EQ(render(odd_, "a.exr").exit_code, 0);
  const AsosRun again = render({"--from", path("a.png")}, "b.png");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.err, "");
  expect_same("a.png", "b.png");
  // An EXR also restores its settings and the exposure it was rendered with.
  ASSERT_EQ(render({"--from", path("a.exr")}, "c.png").exit_code, 0);
  expect_same("a.png", "c.png");
  ASSERT_EQ(render({"--from", path("a.png")}, "b.exr").exit_code, 0);
  const ExrImage a = read_exr(path("a.exr")).value(), b = read_exr(path("b.exr")).value();
  EXPECT_TRUE(a.film.radiance == b.film.radiance);
}

TEST_F(FromOption, OptionsBesideItOverride) {
  ASSERT_EQ(render(odd_, "a.png").exit_code, 0);
  const std::vector<std::string> from{"--from", path("a.png")};
  // Options before and after --from.
  ASSERT_EQ(render(std::vector<std::string>{"--eps", "0.5"} + from +
                       std::vector<std::string>{"--max", "1", "--crop", "0,0,48,27"},
                   "b.png")
                .exit_code,
            0);
  const PictureDescription d = said("b.png");
  EXPECT_EQ(d.settings.asos.eps, 0.5);
  EXPECT_EQ(d.settings.asos.max_level, 1);
  EXPECT_EQ(d.settings.crop, (PixelRect{0, 0, 48, 27}));
  EXPECT_EQ(d.settings.texture.resolution, 2) << "the rest stays";
  EXPECT_EQ(d.sky, said("a.png").sky);
  EXPECT_EQ(d.camera.world_from_camera, said("a.png").camera.world_from_camera);
  ASSERT_EQ(
      render(from + std::vector<std::string>{"--fov", "20", "--needs", "all"}, "f.png").exit_code,
      0);
  EXPECT_NEAR(said("f.png").camera.fov_y_rad, 0.349, 0.001);
  EXPECT_EQ(said("f.png").render_features, FeatureChoice::all);
  ASSERT_EQ(render(from + std::vector<std::string>{"builtin:fence"}, "s.png").exit_code, 0);
  EXPECT_EQ(said("s.png").scene, "builtin:fence");
}

TEST_F(FromOption, FilesAreFoundFromAnywhere) {
  ASSERT_EQ(run_asos({"export-scene", "boxes", "-o", path("s.glb")}).exit_code, 0);
  const std::string relative = std::filesystem::proximate(path("s.glb")).string();
  ASSERT_EQ(render({relative, "--size", "32x18"}, "a.png").exit_code, 0);
  EXPECT_EQ(said("a.png").scene, path("s.glb"));
}

// The command line reproduces the picture that the window saves, with edited lights.
TEST_F(FromOption, GivesTheWindowsPictureBitForBit) {
  RenderSettings settings{.asos = {.max_level = 2}, .threads = 2};
  Previewer previewer({{}, {}}, settings);
  previewer.scene().open("builtin:boxes");
  previewer.viewpoint().set_picture_size(97, 55, 0.0);
  const auto finish = [&] {
    for (int i = 0; i < 20000; ++i) {
      previewer.update(1.0 * i);
      if (previewer.scene() && !previewer.seconds_to_update(1.0 * i) &&
          previewer.render().progress().finished)
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  };
  ASSERT_TRUE(finish());
  EXPECT_FALSE(previewer.render().description({}).lights.has_value()) << "they are the scene's own";
  previewer.viewpoint().camera().orbit(0.3, 0.1);
  ASSERT_FALSE(previewer.edits().lights().empty());
  previewer.edits().edit_lights()[0].light.intensity *= 1.7f;
  previewer.edits().edit_lights()[0].light.color = {1.0f, 0.31f, 0.2f};
  previewer.edits().settings().sky =
      make_sky({SkyChoice::Colours{{0, 0, 1}, {1, 0.5f, 0}}, "", 0}).value();
  ASSERT_TRUE(finish());
  DisplaySettings display{.exposure_ev = -0.4f};
  ASSERT_TRUE(write_png(path("window.png"), previewer.render().film(), display.transform(),
                        screenshot_text(previewer, display)));
  const AsosRun again = render({"--from", path("window.png")}, "again.png");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(png("window.png").rgb == png("again.png").rgb);
  EXPECT_TRUE(said("window.png").lights.has_value());
  EXPECT_EQ(description_text(said("again.png")).find("\"lights\":null"), std::string::npos);

  // A picture that is dropped on the window restores everything.
  Previewer other({{}, {}}, {});
  other.viewpoint().set_picture_size(64, 64, 0.0);
  other.scene().open(path("window.png"));
  for (int i = 0; i < 20000 && !other.scene(); ++i) {
    other.update(1.0 * i);
    ASSERT_FALSE(other.scene().error().has_value()) << other.scene().error()->message();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_NE(other.scene().get(), nullptr);
  EXPECT_EQ(other.edits().settings().asos.max_level, 2);
  EXPECT_EQ(other.edits().settings().width, 64) << "the window's size stays";
  EXPECT_EQ(choice_of(other.edits().settings().sky.get()),
            choice_of(previewer.edits().settings().sky.get()));
  EXPECT_NEAR(glm::distance(other.viewpoint().camera().eye(), previewer.viewpoint().camera().eye()),
              0.0, 1e-9);
  ASSERT_EQ(other.edits().lights().size(), previewer.edits().lights().size());
  EXPECT_EQ(other.edits().lights()[0].light.intensity,
            previewer.edits().lights()[0].light.intensity);
  EXPECT_EQ(other.scene().take_opened_display()->exposure_ev, -0.4f);
  EXPECT_FALSE(other.scene().take_opened_display().has_value()) << "once";
}

TEST_F(FromOption, ErrorsNameTheFile) {
  const RgbImage image{1, 1, {1, 2, 3}, {}};
  ASSERT_TRUE(write_png(path("plain.png"), image));
  AsosRun run = render({"--from", path("plain.png")}, "x.png");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, path("plain.png") + ": holds no settings"));
  run = render({"--from", path("missing.png")}, "x.png");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, path("missing.png")));

  RgbImage lost = image;
  PictureDescription d{.scene = "/nowhere/at all.glb"};
  lost.text = {{PictureDescription::key, description_text(d)}};
  ASSERT_TRUE(write_png(path("lost.png"), lost));
  run = render({"--from", path("lost.png")}, "x.png");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, path("lost.png")));
  EXPECT_TRUE(contains(run.err, "/nowhere/at all.glb"));
  // The command line can name the scene's new path.
  EXPECT_EQ(render({"--from", path("lost.png"), "builtin:boxes", "--size", "8x8", "--look-at",
                    "9,9,9,0,0,0"},
                   "y.png")
                .exit_code,
            0);
  run = run_asos({"render", "-o", path("x.png")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(contains(run.err, "SCENE"));
  EXPECT_FALSE(std::filesystem::exists(path("x.png")));
}

TEST_F(FromOption, AMovedSceneIsFoundBesideThePicture) {
  const auto folder = [&](const char* name) { return std::filesystem::path(path(name)); };
  std::filesystem::create_directories(folder("before"));
  ASSERT_EQ(run_asos({"export-scene", "boxes", "-o", path("before/s.glb")}).exit_code, 0);
  ASSERT_EQ(
      render({path("before/s.glb"), "--size", "16x9", "--max", "0"}, "before/a.png").exit_code, 0);
  std::filesystem::rename(folder("before"), folder("after"));
  const AsosRun run = render({"--from", path("after/a.png")}, "b.png");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(contains(
      run.err, "'" + path("before/s.glb") + "' is gone; 's.glb' beside the picture is used"));
  EXPECT_TRUE(png("after/a.png").rgb == png("b.png").rgb);
  EXPECT_EQ(said("b.png").scene, path("after/s.glb"));
  // A scene that is still in its place is preferred.
  std::filesystem::copy(folder("after"), folder("before"));
  EXPECT_EQ(render({"--from", path("after/a.png")}, "c.png").err, "");
  EXPECT_EQ(said("c.png").scene, path("before/s.glb"));
}

TEST_F(FromOption, ASplitMapsPictureIsRenderedWithoutIt) {
  ASSERT_EQ(render({"builtin:boxes", "--size", "32x18", "--split-map", path("map.png")}, "a.png")
                .exit_code,
            0);
  const AsosRun run = render({"--from", path("map.png")}, "b.png");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(contains(run.err, "map.png shows the split map"));
  EXPECT_TRUE(png("a.png").rgb == png("b.png").rgb);
}

}  // namespace
}  // namespace asos
