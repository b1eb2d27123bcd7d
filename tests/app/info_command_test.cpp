#include "app/scene_info.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "tests/app/run_asos.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace asos {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using test::AsosRun;
using test::contains;
using test::run_asos;

Light light_of(Light::Type type, double radius = 0.0, double angular_diameter_rad = 0.0) {
  return {.type = type, .radius = radius, .angular_diameter_rad = angular_diameter_rad};
}

ordered_json info_of(const Scene& scene) {
  const auto ready = prepare(scene).and_then(with_boundaries);
  if (!ready) throw std::runtime_error(ready.error().message());
  return scene_info_json(scene, **ready);
}

TEST(InfoCommand, CountsLightsByTypeAndThoseWithASizeBeside) {
  using Type = Light::Type;
  Scene scene;
  scene.lights = {light_of(Type::point),       light_of(Type::point, 0.5),
                  light_of(Type::point, 0.1),  light_of(Type::spot, 0.2),
                  light_of(Type::directional), light_of(Type::directional, 0.0, 0.0093),
                  light_of(Type::linear),      light_of(Type::linear),
                  light_of(Type::rectangle),   light_of(Type::disk, 3.0),
                  light_of(Type::polygon)};
  const ordered_json info = info_of(scene);
  const ordered_json expected = {{"point", 3},   {"spot", 1},      {"directional", 2},
                                 {"linear", 2},  {"rectangle", 1}, {"disk", 1},
                                 {"polygon", 1}, {"ball", 3},      {"sun", 1}};
  EXPECT_EQ(info["lights"], expected);
  EXPECT_TRUE(contains(scene_info_text(info),
                       "Lights:     3 point, 1 spot, 2 directional, 2 linear, 1 rectangle, 1 disk, "
                       "1 polygon (of these with a size: 3 ball, 1 sun)\n"));
}

TEST(InfoCommand, SaysWhereThereAreNoLightsOrNoneWithASize) {
  Scene scene;
  EXPECT_TRUE(contains(scene_info_text(info_of(scene)), "Lights:     none"));
  scene.lights = {light_of(Light::Type::spot)};
  EXPECT_TRUE(contains(scene_info_text(info_of(scene)), "Lights:     1 spot\n"));
}

TEST(InfoCommand, NamesTheLightsOfTheBuiltinScenes) {
  const auto lights = [](const char* scene) {
    const AsosRun outcome = run_asos({"info", scene, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out).at("lights");
  };
  EXPECT_EQ(lights("builtin:boxes").at("rectangle"), 1);
  EXPECT_EQ(lights("builtin:house").at("sun"), 1);
  EXPECT_EQ(lights("builtin:primitives").at("ball"), 0);
  EXPECT_EQ(lights("builtin:primitives-ball").at("ball"), 1);
  EXPECT_EQ(lights("builtin:primitives-linear").at("linear"), 1);
  EXPECT_EQ(lights("builtin:primitives-rectangle").at("rectangle"), 1);
}

TEST(InfoCommand, SaysWhatIsLeftOutAndWhy) {
  Scene scene = load_scene("builtin:boxes").value();
  const ordered_json info = info_of(scene);
  const auto entry = [&](const char* feature) {
    const auto found = std::find_if(info["left_out"].begin(), info["left_out"].end(),
                                    [&](const auto& f) { return f["feature"] == feature; });
    return found == info["left_out"].end() ? ordered_json() : *found;
  };
  EXPECT_EQ(entry("normal maps").at("reason"), "no material that is shown has a normal map");
  EXPECT_EQ(entry("normal maps").at("memory"), "tangents, normal maps' mip chains");
  EXPECT_FALSE(entry("normal maps").contains("rows"));
  EXPECT_EQ(entry("disk lights").at("rows"), "disk");
  EXPECT_TRUE(entry("shadows").is_null());
  EXPECT_TRUE(entry("rectangular and polygonal lights").is_null());
  EXPECT_TRUE(contains(scene_info_text(info),
                       "  disk lights: no light is a disk; stages: their irradiance and shadows; "
                       "rows: disk\n"));
}

TEST(InfoCommand, StartsNoSearchForEdges) {
  Scene scene = load_scene("builtin:boxes").value();
  const auto names = [](const ordered_json& info) {
    std::vector<std::string> features;
    for (const auto& left_out : info["left_out"]) features.push_back(left_out["feature"]);
    return features;
  };
  const auto ready = prepare(scene).value();
  const std::vector<std::string> unsearched = names(scene_info_json(scene, *ready));
  EXPECT_FALSE(ready->geometry->boundaries.running());
  EXPECT_EQ(std::count(unsearched.begin(), unsearched.end(), "edges"), 1);
  const std::vector<std::string> searched = names(info_of(scene));
  EXPECT_EQ(std::count(searched.begin(), searched.end(), "edges"), 0);
  EXPECT_TRUE(contains(run_asos({"info", "builtin:boxes"}).out, "  edges: only methods that cut"));
}

TEST(InfoCommand, ForcesEverythingOnWhenAsked) {
  const auto info = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"info", "builtin:boxes", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const AsosRun outcome = run_asos(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  };
  const json needed = info({});
  const json forced = info({"--needs", "all"});
  EXPECT_GT(needed.at("left_out").size(), 8u);
  EXPECT_EQ(forced.at("left_out").size(), 2u) << forced.at("left_out");
  EXPECT_GT(forced.at("memory_mb").get<double>(), needed.at("memory_mb").get<double>());
}

TEST(InfoCommand, CountsAnalyticShapes) {
  const AsosRun outcome = run_asos({"info", "builtin:solids"});
  EXPECT_TRUE(contains(outcome.out, "Shapes:     3 analytic instances\n")) << outcome.out;
  EXPECT_FALSE(contains(outcome.out, "analytic shapes: no object"));
  EXPECT_FALSE(contains(outcome.out, "mirrors: no material"));
  EXPECT_TRUE(contains(run_asos({"info", "builtin:boxes"}).out, "analytic shapes: no object"));
}

TEST(InfoCommand, LongListsEndWithHowManyMoreThereAre) {
  Scene scene;
  constexpr std::size_t count = 10'000;
  scene.cameras.resize(count);
  scene.contents.animations.resize(count);
  scene.contents.skins.resize(count);
  scene.contents.morphs.resize(count);
  for (auto* names :
       {&scene.contents.variants, &scene.contents.scenes, &scene.notes.unsupported_extensions,
        &scene.notes.not_shown, &scene.notes.warnings})
    names->assign(count, "ACME_gizmo");
  const ordered_json info = info_of(scene);
  const auto lines = [](const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  };
  const std::string brief = scene_info_text(info);
  EXPECT_LT(lines(brief), 9 * (most_lines_a_list + 2) + 60);
  EXPECT_LT(brief.size(), 20'000u);
  for (const char* title : {"Cameras:    10000\n", "Animations: 10000\n", "Skins:      10000\n",
                            "Morphs:     10000\n", "Variants:   10000\n", "Scenes:     10000\n"})
    EXPECT_TRUE(contains(brief, title));
  EXPECT_TRUE(contains(brief, "  ... and 9980 more, which --all lists\n"));
  EXPECT_TRUE(contains(brief, "ACME_gizmo and 9980 more\n"));
  const std::string all = scene_info_text(info, count);
  EXPECT_GT(lines(all), 8 * count);
  EXPECT_FALSE(contains(all, " more"));
  scene.cameras.resize(most_lines_a_list);
  scene.contents = {};
  scene.notes = {};
  EXPECT_FALSE(contains(scene_info_text(info_of(scene)), "more, which"));
}

TEST(InfoCommand, PunctualLightsOfAFileAreCountedByTheTypesOfTheirExtension) {
  const auto dir = test::shared_dir();
  if (!dir) GTEST_SKIP() << "no models: set ASOS_SHARED to a folder with scenes/";
  const auto file = *dir / "scenes" / "PlayCanvasLights" / "Lights.glb";
  const AsosRun outcome = run_asos({"info", file.string(), "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json lights = json::parse(outcome.out).at("lights");
  EXPECT_EQ(lights.at("point"), 1);
  EXPECT_EQ(lights.at("spot"), 2);
  EXPECT_EQ(lights.at("directional"), 1);
  for (const char* kind : {"linear", "rectangle", "disk", "polygon", "ball", "sun"}) {
    EXPECT_EQ(lights.at(kind), 0) << kind;
  }
}

}  // namespace
}  // namespace asos
