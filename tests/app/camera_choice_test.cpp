#include "app/camera_choice.h"

#include "renderer/film/image_io.h"
#include "tests/app/run_asos.h"
#include "tests/support/shared_dir.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace asos {
namespace {

// A triangle within one unit of the author's point (100, 0, 0) along each axis.
World small_world() {
  World world{.origin = {100, 0, 0},
              .positions = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}},
              .triangles = {{0, 1, 2}}};
  for (const glm::vec3 p : world.positions) world.bounds.grow(p);
  return world;
}

TEST(CameraChoice, LookAtIsInTheAuthorsCoordinates) {
  const CameraChoice choice{{}, LookAt{{100, 0, 5}, {100, 0, 0}}, {}, 40.0};
  const auto camera = choose_camera(small_world(), choice, 1.5);
  ASSERT_TRUE(camera);
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[3]), glm::dvec3(0, 0, 5));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[0]), glm::dvec3(1, 0, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[1]), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[2]), glm::dvec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(camera->fov_y_rad, 40.0 * glm::pi<double>() / 180.0);
}

TEST(CameraChoice, LookingStraightDownIsDefined) {
  const CameraChoice choice{{}, LookAt{{100, 9, 0}, {100, 0, 0}}, {}, {}};
  const auto camera = choose_camera(small_world(), choice, 1.0);
  ASSERT_TRUE(camera);
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[2]), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[1]), glm::dvec3(0, 0, -1));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[0]), glm::dvec3(1, 0, 0));
}

TEST(CameraChoice, TheFilesFirstCameraIsTheDefault) {
  World world = small_world();
  world.cameras.resize(2);
  world.cameras[0].name = "first";
  world.cameras[1].name = "second";
  EXPECT_EQ(choose_camera(world, {}, 1.0)->name, "first");
  EXPECT_EQ(choose_camera(world, {1, {}, {}, {}}, 1.0)->name, "second");
}

TEST(CameraChoice, CamerasThatAreNotThereAreRefused) {
  World world = small_world();
  EXPECT_EQ(choose_camera(world, {0, {}, {}, {}}, 1.0).error().reason, "the scene has no cameras");
  world.cameras.resize(2);
  EXPECT_EQ(choose_camera(world, {2, {}, {}, {}}, 1.0).error().reason,
            "the scene's cameras are numbered 0 to 1");
}

TEST(CameraChoice, AWideCameraIsFittedAndThatIsSaid) {
  World world = small_world();
  world.cameras.resize(1);
  world.cameras[0].name = "wide";
  world.cameras[0].fov_y_rad = 0.5;
  world.cameras[0].aspect_ratio = 3.0;
  CameraChoice choice;
  const double fitted = 2.0 * std::atan(2.0 * std::tan(0.25));
  EXPECT_DOUBLE_EQ(choose_camera(world, choice, 1.5)->fov_y_rad, fitted);
  EXPECT_EQ(fit_remark(world, choice, 1.5),
            "camera 'wide' has the aspect ratio 3 and the picture 1.5: its vertical angle in "
            "degrees is 54.11 instead of 28.65 (--fit)");
  EXPECT_EQ(fit_remark(world, choice, 3.0), "");
  EXPECT_EQ(fit_remark(world, choice, 4.0), "");
  choice.fit = CameraFit::fill;
  EXPECT_DOUBLE_EQ(choose_camera(world, choice, 6.0)->fov_y_rad,
                   2.0 * std::atan(0.5 * std::tan(0.25)));
  choice.fit = CameraFit::crop;
  EXPECT_EQ(choose_camera(world, choice, 1.5)->fov_y_rad, 0.5);
  EXPECT_EQ(fit_remark(world, choice, 1.5), "");
  // An explicit angle is used unchanged.
  choice.fit = CameraFit::fit;
  choice.fov_y_deg = 40.0;
  EXPECT_DOUBLE_EQ(choose_camera(world, choice, 1.5)->fov_y_rad, 40.0 * glm::pi<double>() / 180.0);
  EXPECT_EQ(fit_remark(world, choice, 1.5), "");
}

// A camera with the aspect ratio 2.67 shows its three white squares at any picture size.
TEST(CameraChoice, TheReportedWideCameraShowsItsThreeSquares) {
  const auto shared = test::shared_dir();
  if (!shared || !std::filesystem::is_directory(*shared / "reported"))
    GTEST_SKIP() << "no files: set ASOS_SHARED to a folder with reported";
  const test::TemporaryFolder folder;
  const std::string scene = *shared / "reported/camera-aspect-ratio-2.67-cropped.glb";
  const auto squares = [&](const std::string& size, const std::string& fit) {
    const test::AsosRun run =
        test::run_asos({"render", scene, "-o", folder.file("a.exr"), "--size", size, "--method",
                        "sobol", "--spp", "1", "--sky", "0,0,0", "--fit", fit});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(test::contains(run.err, "(--fit)"), fit != "crop") << run.err;
    const Film film = read_exr(folder.file("a.exr")).value().film;
    int begun = 0;
    bool inside = false;
    for (int x = 0; x < film.width; ++x) {
      const bool white = film.radiance[film.index(x, film.height / 2)].g > 0.5f;
      begun += white && !inside ? 1 : 0;
      inside = white;
    }
    return begun;
  };
  EXPECT_EQ(squares("160x90", "fit"), 3);
  EXPECT_EQ(squares("100x100", "fit"), 3);
  EXPECT_EQ(squares("160x90", "crop"), 1);
}

// A red wall in front of the near plane, a blue one behind it.
TEST(CameraChoice, PlanesThatCutAreSaidAndCanBeLeftOut) {
  const auto shared = test::shared_dir();
  if (!shared || !std::filesystem::is_directory(*shared / "reported"))
    GTEST_SKIP() << "no files: set ASOS_SHARED to a folder with reported";
  const test::TemporaryFolder folder;
  const std::string scene = *shared / "reported/camera-znear-ignored_orthographic.glb";
  const auto said = [&](const std::vector<std::string>& more) {
    using test::operator+;
    return test::run_asos(std::vector<std::string>{"render", scene, "-o", folder.file("a.exr"),
                                                   "--size", "32x18", "--max", "0"} +
                          more)
        .err;
  };
  const auto centre = [&] {
    const Film film = read_exr(folder.file("a.exr")).value().film;
    return film.radiance[film.index(film.width / 2, film.height / 2)];
  };
  EXPECT_TRUE(test::contains(said({}), "nearer than 4 (znear) (--clip off shows them)"));
  EXPECT_EQ(centre(), glm::vec3(0, 0, 1));
  EXPECT_EQ(said({"--clip", "off"}).find("znear"), std::string::npos);
  EXPECT_EQ(centre(), glm::vec3(1, 0, 0));
  EXPECT_EQ(said({"--look-at", "0,0,9,0,0,0"}).find("znear"), std::string::npos);
}

TEST(CameraChoice, OrthographicCamerasHaveNoFieldOfView) {
  World world = small_world();
  world.cameras.resize(1);
  world.cameras[0].type = Camera::Type::orthographic;
  EXPECT_TRUE(choose_camera(world, {}, 1.0));
  EXPECT_FALSE(choose_camera(world, {{}, {}, {}, 40.0}, 1.0));
}

CameraChoice with_lens(const LensChoice& lens) {
  return {.lens = lens};
}

TEST(CameraChoice, LensIsThatOfTheCommandLine) {
  World world = small_world();
  world.cameras.resize(1);
  world.cameras[0].fov_y_rad = 0.8;
  world.cameras[0].lens = {0.5, 3.0, 6, 0.1};
  EXPECT_EQ(choose_camera(world, {}, 1.0)->lens, world.cameras[0].lens);
  LensChoice lens{.radius = 0.0};
  EXPECT_FALSE(choose_camera(world, with_lens(lens), 1.0)->lens.blurs());
  lens.radius = 0.25;
  lens.focus = 9.0;
  EXPECT_EQ(choose_camera(world, with_lens(lens), 1.0)->lens, (Lens{0.25, 9.0, 6, 0.1}));
  LensChoice stop{.f_stop = 2.8, .turn_deg = 180.0, .blades = 0};
  EXPECT_EQ(choose_camera(world, with_lens(stop), 1.0)->lens,
            (Lens{aperture_of_f_stop(2.8, 0.8), 3.0, 0, glm::pi<double>()}));
}

TEST(CameraChoice, OrthographicCamerasHaveNoLens) {
  World world = small_world();
  world.cameras.resize(1);
  world.cameras[0].type = Camera::Type::orthographic;
  LensChoice lens{.radius = 0.1};
  const auto camera = choose_camera(world, with_lens(lens), 1.0);
  ASSERT_FALSE(camera);
  EXPECT_EQ(camera.error().reason, "the chosen camera is orthographic and has no lens");
}

TEST(CameraChoice, LensIsSavedAndRestored) {
  const test::TemporaryFolder folder;
  const auto render = [&](const std::vector<std::string>& words) {
    using test::operator+;
    const test::AsosRun run =
        test::run_asos(std::vector<std::string>{"render", "--size", "32x18", "--max", "1"} + words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.err;
  };
  const auto pixels = [&](const std::string& name) {
    return read_exr(folder.file(name)).value().film.radiance;
  };
  render({"builtin:boxes", "-o", folder.file("sharp.exr")});
  render({"builtin:boxes", "-o", folder.file("zero.exr"), "--aperture", "0", "--focus", "2"});
  render({"builtin:boxes", "-o", folder.file("a.exr"), "--f-stop", "0.5", "--focus", "3"});
  render({"--from", folder.file("a.exr"), "-o", folder.file("b.exr")});
  EXPECT_EQ(pixels("zero.exr"), pixels("sharp.exr"));
  EXPECT_NE(pixels("a.exr"), pixels("sharp.exr"));
  EXPECT_EQ(pixels("b.exr"), pixels("a.exr"));
  render({"--from", folder.file("a.exr"), "-o", folder.file("c.exr"), "--aperture", "0"});
  EXPECT_EQ(pixels("c.exr"), pixels("sharp.exr"));
}

TEST(CameraChoice, LensOptionsAreChecked) {
  const test::TemporaryFolder folder;
  const auto said = [&](const std::vector<std::string>& words, int exit_code) {
    using test::operator+;
    const test::AsosRun run = test::run_asos(
        std::vector<std::string>{"render", "builtin:boxes", "-o", folder.file("a.exr"), "--size",
                                 "16x9", "--max", "0"} +
        words);
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    return run.err;
  };
  for (const char* bad : {"-1", "nan", "inf", "1e300", "wide"})
    EXPECT_TRUE(test::contains(said({"--aperture", bad}, 2), "--aperture")) << bad;
  for (const char* bad : {"0", "-2", "1e9"})
    EXPECT_TRUE(test::contains(said({"--f-stop", bad}, 2), "--f-stop")) << bad;
  EXPECT_TRUE(test::contains(said({"--focus", "0"}, 2), "ahead of the camera"));
  EXPECT_TRUE(test::contains(said({"--focus", "-3"}, 2), "--focus"));
  EXPECT_TRUE(test::contains(said({"--blades", "2"}, 2), "0 or 3 to 32"));
  EXPECT_TRUE(test::contains(said({"--blades", "99"}, 2), "--blades"));
  EXPECT_TRUE(test::contains(said({"--aperture", "1", "--f-stop", "2"}, 2), "--f-stop"));
  EXPECT_TRUE(test::contains(said({"--focus", "3"}, 0), "no effect without"));
  EXPECT_TRUE(
      test::contains(said({"--aperture", "0.1", "--method", "beam"}, 0), "without depth of field"));
  // Automatic focus is on the scene.
  EXPECT_TRUE(test::contains(said({"--aperture", "1e15"}, 0), "has a radius of 1e+15, but its"));
  EXPECT_TRUE(test::contains(said({"--aperture", "2", "--focus", "1.5"}, 0), "only 1.5 ahead"));
  EXPECT_EQ(said({"--aperture", "1.5", "--focus", "2"}, 0).find("radius"), std::string::npos);
}

}  // namespace
}  // namespace asos
