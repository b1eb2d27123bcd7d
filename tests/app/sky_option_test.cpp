#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "tests/app/run_asos.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asos {
namespace {

using test::AsosRun;
using test::contains;
using test::run_asos;
using test::operator+;

class SkyOption : public testing::Test {
 protected:
  /// Renders straight up from above the scene: only sky.
  [[nodiscard]] AsosRun render(const std::string& name, const std::vector<std::string>& words) {
    return run_asos(std::vector<std::string>{"render", "builtin:boxes", "-o", folder_.file(name),
                                             "--size", "8x8", "--look-at", "0,900,0,0.1,2000,-1"} +
                    words);
  }
  [[nodiscard]] glm::vec3 pixel(const std::string& name) const {
    const Result<ExrImage> image = read_exr(folder_.file(name));
    return image ? image->film.radiance[image->film.index(4, 4)] : glm::vec3(-1.0f);
  }
  [[nodiscard]] std::string picture(const std::string& name, glm::vec3 colour) const {
    Film film(16, 8);
    film.radiance.assign(128, colour);
    EXPECT_TRUE(write_exr(folder_.file(name), film, {}));
    return folder_.file(name);
  }

  test::TemporaryFolder folder_;
};

TEST_F(SkyOption, IsWhatIsSeenAroundTheScene) {
  EXPECT_EQ(render("neutral.exr", {"--sky", "neutral"}).exit_code, 0);
  EXPECT_EQ(pixel("neutral.exr"), glm::vec3(0.35f));
  EXPECT_EQ(render("colour.exr", {"--sky", "0.25,0.5,2"}).exit_code, 0);
  EXPECT_EQ(pixel("colour.exr"), glm::vec3(0.25f, 0.5f, 2));
  EXPECT_EQ(render("gradient.exr", {"--sky", "0,0,1:1,1,1"}).exit_code, 0);
  EXPECT_LT(pixel("gradient.exr").r, 0.2f);
  EXPECT_NEAR(pixel("gradient.exr").b, 1.0f, 1e-6f);
  const std::string file = picture("a sky.exr", {1, 0.5f, 0.125f});
  EXPECT_EQ(render("file.exr", {"--sky", file, "--sky-turn", "45"}).exit_code, 0);
  EXPECT_EQ(pixel("file.exr"), glm::vec3(1, 0.5f, 0.125f));
  const auto said = read_description(folder_.file("file.exr"));
  ASSERT_TRUE(said);
  EXPECT_EQ(said->sky, (SkyChoice{{}, file, 45.0})) << "the picture says what its sky was";
}

TEST_F(SkyOption, AFileIsAsBrightAsAskedFor) {
  const std::string file = picture("sky.exr", {1, 0.5f, 0.125f});
  EXPECT_EQ(render("bright.exr", {"--sky-brightness", "4", "--sky", file}).exit_code, 0);
  EXPECT_EQ(pixel("bright.exr"), glm::vec3(4, 2, 0.5f));
  EXPECT_EQ(run_asos({"render", "--from", folder_.file("bright.exr"), "-o", folder_.file("a.exr")})
                .exit_code,
            0);
  EXPECT_EQ(pixel("a.exr"), glm::vec3(4, 2, 0.5f));
  EXPECT_EQ(run_asos({"render", "--from", folder_.file("bright.exr"), "--sky-brightness", "0", "-o",
                      folder_.file("b.exr")})
                .exit_code,
            0);
  EXPECT_EQ(pixel("b.exr"), glm::vec3(0));
  for (const char* bad : {"-1", "1001", "nan", "inf", "x"})
    EXPECT_EQ(render("x.exr", {"--sky", file, "--sky-brightness", bad}).exit_code, 2) << bad;
}

// A file without lights: the sun replaces its default lighting, and the picture stores it.
TEST_F(SkyOption, AnEnvironmentBringsItsLights) {
  const std::string file = folder_.write("bare.glb", test::GltfBuilder::square().glb());
  const auto shot = [&](const std::vector<std::string>& words, const std::string& to) {
    const AsosRun run =
        run_asos(std::vector<std::string>{"render"} + words +
                 std::vector<std::string>{"-o", folder_.file(to), "--size", "24x16"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_exr(folder_.file(to)).value().film.radiance;
  };
  const auto lights = [&](const std::string& name) {
    std::vector<std::string> names;
    if (const auto said = read_description(folder_.file(name)).value().lights)
      for (const Light& light : *said) names.push_back(light.name);
    return names;
  };
  const auto plain = shot({file, "--sky", "neutral"}, "plain.exr");
  const auto day = shot({file, "--sky", "daylight"}, "day.exr");
  EXPECT_TRUE(plain != day);
  EXPECT_EQ(read_description(folder_.file("day.exr")).value().sky.environment,
            Environment::daylight);
  EXPECT_EQ(lights("plain.exr").size(), 0u) << "its own";
  EXPECT_EQ(lights("day.exr"), std::vector<std::string>{"sun"});
  EXPECT_TRUE(shot({"--from", folder_.file("day.exr")}, "again.exr") == day);
  EXPECT_TRUE(shot({"--from", folder_.file("day.exr"), "--sky", "neutral"}, "back.exr") == plain);
  const auto dusk = shot({file, "--sky", "dusk"}, "dusk.exr");
  EXPECT_TRUE(shot({"--from", folder_.file("day.exr"), "--sky", "dusk"}, "later.exr") == dusk);
  EXPECT_EQ(render("x.exr", {"--sky", "noon"}).exit_code, 2);
}

// --from reproduces a picture with default lighting, also with a rotated and brighter sky.
TEST_F(SkyOption, ADefaultPictureIsRenderedAgainAsItWas) {
  const std::string bare = folder_.write("bare.glb", test::GltfBuilder::square().glb());
  const auto shot = [&](const std::vector<std::string>& words, const std::string& to) {
    const AsosRun run = run_asos(std::vector<std::string>{"render"} + words +
                                 std::vector<std::string>{"-o", folder_.file(to)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_exr(folder_.file(to)).value().film.radiance;
  };
  const std::vector<std::string> small{bare, "--size", "24x16"};
  const auto plain = shot(small, "plain.exr");
  EXPECT_TRUE(shot({"--from", folder_.file("plain.exr")}, "again.exr") == plain);
  const auto placed = shot(
      small + std::vector<std::string>{"--sky-turn", "120", "--sky-brightness", "2"}, "placed.exr");
  EXPECT_TRUE(placed != plain);
  EXPECT_TRUE(shot({"--from", folder_.file("placed.exr")}, "placed2.exr") == placed);
}

TEST_F(SkyOption, FilesThatAreNoneAreNamedWithExitCodeOne) {
  const std::string bad = picture("bad.exr", {1, std::numeric_limits<float>::quiet_NaN(), 1});
  const std::string missing = folder_.file("missing.hdr");
  for (const std::string& file : {bad, missing}) {
    const AsosRun run = render("x.exr", {"--sky", file});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(contains(run.err, file));
    const AsosRun trace =
        run_asos({"trace", "builtin:boxes", "--size", "8x8", "--pixel", "4,4", "--sky", file});
    EXPECT_EQ(trace.exit_code, 1);
    EXPECT_TRUE(contains(trace.err, file));
  }
  EXPECT_TRUE(
      contains(render("x.exr", {"--sky", bad}).err, "128 of its 128 pixels are not finite"));
}

// Scenes with lights, and renders with --sky, do not get the studio.
TEST_F(SkyOption, ScenesWithoutLightsStandInAStudioWithSoftBoxes) {
  const std::string bare = folder_.write("bare.glb", test::GltfBuilder::square().glb());
  const auto sky_of = [&](const std::string& scene, const std::vector<std::string>& words) {
    const AsosRun run = run_asos(
        std::vector<std::string>{"render", scene, "-o", folder_.file("a.png"), "--size", "8x8"} +
        words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return read_description(folder_.file("a.png")).value().sky;
  };
  const auto settings = [&] { return read_description(folder_.file("a.png")).value().settings; };
  EXPECT_EQ(sky_of(bare, {}).environment, Environment::softboxes);
  EXPECT_EQ(settings().ground, Ground::on);
  EXPECT_EQ(settings().background.kind, BackgroundKind::colours);
  const SkyChoice placed = sky_of(bare, {"--sky-turn", "40", "--sky-brightness", "2"});
  EXPECT_EQ(placed.environment, Environment::softboxes);
  EXPECT_EQ(placed.turn_deg, 40.0);
  EXPECT_EQ(placed.brightness, 2.0);
  EXPECT_EQ(sky_of(bare, {"--ground", "off", "--background", "environment"}).environment,
            Environment::softboxes);
  EXPECT_EQ(settings().ground, Ground::off);
  EXPECT_EQ(settings().background, Background{});
  EXPECT_EQ(sky_of(bare, {"--sky", "studio"}).environment, Environment::studio);
  EXPECT_EQ(settings().ground, Ground::off) << "the look goes with the sky";
  EXPECT_EQ(settings().background, Background{});
  EXPECT_EQ(sky_of(bare, {"--sky", "neutral"}), SkyChoice{});
  EXPECT_EQ(sky_of("builtin:boxes", {}), SkyChoice{});
  EXPECT_EQ(settings().ground, Ground::off);
  EXPECT_EQ(settings().background, Background{});
  // A picture saved before this default existed is reproduced as it was.
  EXPECT_EQ(sky_of(bare, {"--sky", "neutral"}), SkyChoice{});
  const AsosRun again =
      run_asos({"render", "--from", folder_.file("a.png"), "-o", folder_.file("b.png")});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(read_description(folder_.file("b.png")).value().sky, SkyChoice{});
}

TEST_F(SkyOption, BackgroundAndGroundTravelWithThePicture) {
  const auto render_to = [&](const std::string& name, const std::vector<std::string>& words) {
    const AsosRun run =
        run_asos(std::vector<std::string>{"render", "-o", folder_.file(name)} + words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(contains(run.out, " triangles")) << run.out;
    return run.out.substr(0, run.out.find(" triangles")).substr(run.out.find(": "));
  };
  const std::vector<std::string> small{"builtin:boxes", "--size", "24x16", "--max", "1"};
  const std::string triangles = render_to("plain.exr", small);
  EXPECT_EQ(render_to("a.exr", small + std::vector<std::string>{"--ground", "mirror",
                                                                "--background", "transparent"}),
            triangles)
      << "the ground is not counted";
  const auto said = read_description(folder_.file("a.exr")).value();
  EXPECT_EQ(said.settings.background.kind, BackgroundKind::transparent);
  EXPECT_EQ(said.settings.ground, Ground::mirror);
  EXPECT_FALSE(said.dfrs) << "nor are its materials";
  render_to("b.exr", {"--from", folder_.file("a.exr")});
  const Film first = read_exr(folder_.file("a.exr")).value().film;
  const Film second = read_exr(folder_.file("b.exr")).value().film;
  EXPECT_EQ(first.radiance, second.radiance);
  EXPECT_EQ(first.coverage, second.coverage);
  EXPECT_FALSE(first.coverage.empty());
  render_to("c.exr",
            {"--from", folder_.file("a.exr"), "--ground", "off", "--background", "environment"});
  EXPECT_EQ(read_exr(folder_.file("c.exr")).value().film.radiance,
            read_exr(folder_.file("plain.exr")).value().film.radiance);
}

/// A square lit by a sun, seen frontally.
std::string sunlit_square(double lux) {
  test::GltfBuilder b = test::GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", lux}}};
  b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0.0}}}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  return b.glb();
}

TEST_F(SkyOption, ExposureFollowsLightsThatWhitenThePicture) {
  const std::string bright = folder_.write("bright.glb", sunlit_square(100000.0));
  const std::string dim = folder_.write("dim.glb", sunlit_square(1.0));
  const auto shot = [&](const std::string& scene, const std::vector<std::string>& words,
                        const std::string& size = "16x16") {
    const AsosRun run = run_asos(
        std::vector<std::string>{"render", scene, "-o", folder_.file("a.png"), "--size", size,
                                 "--method", "sobol", "--look-at", "0.5,0.5,1,0.5,0.5,0"} +
        words);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return std::pair(read_description(folder_.file("a.png")).value().display.exposure_ev, run.err);
  };
  const auto [stops, said] = shot(bright, {});
  EXPECT_LT(stops, -14.0f);
  EXPECT_GT(stops, -16.0f);
  EXPECT_TRUE(contains(said, "note: exposure -15")) << said;
  EXPECT_EQ(shot(bright, {"--threads", "3"}, "48x48").first, stops);
  const auto [kept, quiet] = shot(bright, {"--exposure", "0"});
  EXPECT_EQ(kept, 0.0f);
  EXPECT_FALSE(contains(quiet, "exposure")) << quiet;
  EXPECT_EQ(shot(dim, {}).first, 0.0f);
  const auto [lifted, why] = shot(dim, {"--exposure", "auto"});
  EXPECT_GT(lifted, 0.1f);
  EXPECT_TRUE(contains(why, "note: exposure +")) << why;
  // --from reproduces a saved picture.
  (void)shot(bright, {"--exposure", "1"});
  const AsosRun again =
      run_asos({"render", "--from", folder_.file("a.png"), "-o", folder_.file("b.png")});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(read_description(folder_.file("b.png")).value().display.exposure_ev, 1.0f);
}

}  // namespace
}  // namespace asos
