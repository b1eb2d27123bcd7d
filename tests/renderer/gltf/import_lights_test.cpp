#include "tests/renderer/gltf/light_checks.h"
#include "tests/renderer/gltf/light_file.h"

#include <gtest/gtest.h>

// Lights of glTF's extensions and proposals, with their sizes.

namespace asos {
namespace {

using nlohmann::json;
using test::expect_close;
using test::LightFile;

constexpr double pi = 3.14159265358979323846;
constexpr const char* punctual = "KHR_lights_punctual";
constexpr const char* ext_area = "EXT_lights_area";
constexpr const char* khr_area = "KHR_lights_area";

json sized(const char* type, const char* name, const json& size) {
  json light = {{"type", type}, {"name", "bulb of the lamp"}, {"extras", {{name, size}}}};
  if (light["type"] == "spot") light["spot"] = {{"outerConeAngle", 0.5}};
  return light;
}

TEST(ImportPunctualSize, ARadiusInExtrasMakesABallThatGrowsWithItsNode) {
  for (const char* type : {"point", "spot"}) {
    SCOPED_TRACE(type);
    LightFile file;
    const Light plain = file.with(punctual, sized(type, "radius", 0.25)).light();
    EXPECT_EQ(plain.radius, 0.25);
    const Light scaled = file.turned({1, 2, 3}, {2, -3, 1}).light();
    EXPECT_NEAR(scaled.radius, 0.75, 1e-15);
    EXPECT_EQ(scaled.intensity, plain.intensity);
    EXPECT_EQ(scaled.position, glm::dvec3(1, 2, 3));
  }
}

TEST(ImportPunctualSize, ASunsDiskDoesNotGrowWithItsNode) {
  LightFile file;
  file.with(punctual, sized("directional", "angular_diameter", 0.0093)).turned({}, {4, 4, 4});
  const Light sun = file.light();
  EXPECT_EQ(sun.angular_diameter_rad, 0.0093);
  EXPECT_EQ(sun.radius, 0.0);
}

TEST(ImportPunctualSize, TheNodesExtrasGoBeforeTheLights) {
  LightFile file;
  file.with(punctual, sized("point", "radius", 0.25));
  file.node()["extras"] = {{"radius", 2}, {"author", "somebody"}};
  EXPECT_EQ(file.light().radius, 2.0);
  // A size that does not apply to the light's type is ignored.
  LightFile sun;
  sun.with(punctual, sized("directional", "radius", 0.25));
  EXPECT_EQ(sun.light().radius, 0.0);
}

TEST(ImportPunctualSize, BadSizesAreWarnedOfAndTheLightHasNone) {
  const auto expect_none = [](const char* type, const char* name, const json& size) {
    SCOPED_TRACE(size.dump());
    LightFile file;
    const Scene scene = file.with(punctual, sized(type, name, size)).load();
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].radius, 0.0);
    EXPECT_EQ(scene.lights[0].angular_diameter_rad, 0.0);
    LightFile::expect_warning(scene, "light 0 'bulb of the lamp'");
    LightFile::expect_warning(scene, name);
  };
  for (const json& size : {json(-1), json("0.5"), json(json::array({1})), json(true)}) {
    expect_none("point", "radius", size);
    expect_none("spot", "radius", size);
    expect_none("directional", "angular_diameter", size);
  }
  expect_none("directional", "angular_diameter", 3.1415927);
  LightFile endless;
  endless.with(punctual, sized("point", "radius", 1e300)).turned({}, glm::dvec3(1e30));
  const Scene scene = endless.load();
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].radius, 0.0);
  LightFile::expect_warning(scene, "light 0 'bulb of the lamp'");
}

TEST(ImportPunctualSize, ZerosAndOnesStandForNoAndYes) {
  // Programs without booleans save them as 0 and 1.
  LightFile file;
  EXPECT_FALSE(file.with(punctual, sized("point", "casts_shadows", 0)).light().casts_shadows);
  LightFile other;
  EXPECT_TRUE(other.with(punctual, sized("point", "casts_shadows", 1)).light().casts_shadows);
}

TEST(ImportAreaLight, ARectangleLiesInItsNodesPlaneAndShinesAlongMinusZ) {
  LightFile file;
  file.with(ext_area, {{"type", "rect"},
                       {"name", "panel"},
                       {"color", {1.0, 0.5, 0.25}},
                       {"intensity", 70},
                       {"size", 2},
                       {"rect", {{"aspect", 1.5}}}});
  const Light light = file.turned({1, 2, 3}, {1, 1, 1}).light();
  EXPECT_EQ(light.type, Light::Type::rectangle);
  EXPECT_EQ(light.name, "panel");
  EXPECT_EQ(light.color, glm::vec3(1.0f, 0.5f, 0.25f));
  EXPECT_EQ(light.intensity, 70.0f);
  EXPECT_EQ(light.position, glm::dvec3(1, 2, 3));
  expect_close(light.direction, {-1, 0, 0});
  expect_close(light.half_u, {0, 0, -1.5});
  expect_close(light.half_v, {0, 1, 0});
  EXPECT_FALSE(light.two_sided);
  EXPECT_TRUE(light.casts_shadows);
}

TEST(ImportAreaLight, SizesAndDefaultsAreThoseOfTheirProposals) {
  LightFile rect, disk, wide, round, ball;
  const Light square = rect.with(ext_area, {{"type", "rect"}}).light();
  EXPECT_EQ(square.name, "lamp");
  EXPECT_EQ(square.intensity, 1000.0f);
  expect_close(square.half_u, {0.5, 0, 0});
  expect_close(square.half_v, {0, 0.5, 0});
  // The size of a disk is its diameter; `shape` has the value that the proposal's schema gives for
  // `type`.
  const Light half = disk.with(ext_area, {{"shape", "disk"}}).light();
  EXPECT_EQ(half.type, Light::Type::disk);
  EXPECT_EQ(half.radius, 0.5);
  const Light tall = wide.with(khr_area, {{"shape", "rect"}, {"height", 3}}).light();
  EXPECT_EQ(tall.intensity, 1.0f);
  expect_close(tall.half_u, {0.5, 0, 0});
  expect_close(tall.half_v, {0, 1.5, 0});
  EXPECT_EQ(round.with(khr_area, {{"shape", "disk"}}).light().radius, 1.0);
  // A sphere of radius r and radiance L has pi r^2 L candela: twice the radius, four times the
  // light.
  ball.with(khr_area, {{"shape", "sphere"}, {"radius", 0.5}, {"intensity", 10}});
  const Light small = ball.light(), large = ball.turned({}, glm::dvec3(2)).light();
  EXPECT_EQ(small.type, Light::Type::point);
  EXPECT_EQ(small.radius, 0.5);
  EXPECT_NEAR(small.intensity, 2.5 * pi, 1e-6);
  EXPECT_NEAR(large.radius, 1.0, 1e-15);
  EXPECT_NEAR(large.intensity, 10.0 * pi, 1e-5);
}

TEST(ImportAreaLight, TheLargestComponentOfTheScaleEnlargesItAllOver) {
  LightFile file;
  file.with(ext_area, {{"type", "rect"}, {"size", 2}, {"rect", {{"aspect", 0.5}}}});
  const Light light = file.turned({}, {0.5, -3, 2}).light();
  EXPECT_NEAR(glm::length(light.half_u), 1.5, 1e-14);
  EXPECT_NEAR(glm::length(light.half_v), 3.0, 1e-14);
  EXPECT_EQ(light.intensity, 1000.0f);  // radiance stays: the light's power grows with its area
  LightFile disk;
  EXPECT_NEAR(disk.with(ext_area, {{"type", "disk"}}).turned({}, {0.5, 1, 4}).light().radius, 2.0,
              1e-14);
}

TEST(ImportAreaLight, AxesAreAtRightAnglesUnderShear) {
  LightFile file;
  file.with(ext_area, {{"type", "rect"}, {"size", 1}});
  file.node()["matrix"] = {1, 0, 0, 0, 0.4, 1, 0.2, 0, 0.1, 0.3, 1, 0, 0, 0, 0, 1};
  const Light light = file.load().lights.at(0);
  EXPECT_NEAR(glm::dot(light.half_u, light.half_v), 0.0, 1e-15);
  EXPECT_NEAR(glm::dot(light.half_u, light.direction), 0.0, 1e-15);
  EXPECT_NEAR(glm::dot(light.half_v, light.direction), 0.0, 1e-15);
  EXPECT_GT(light.half_v.y, 0.0);
  expect_close(light.direction, -glm::normalize(glm::dvec3(0.1, 0.3, 1)));
  expect_close(glm::dvec3(glm::length(light.half_u)), glm::dvec3(glm::length(light.half_v)));
}

TEST(ImportAreaLight, BadOnesAreLeftOutByName) {
  const auto left_out = [](json light, const std::string& words, const char* name = ext_area) {
    SCOPED_TRACE(light.dump());
    LightFile file;
    file.with(name, std::move(light)).expect_left_out(words);
  };
  left_out({{"type", "rect"}, {"size", 0}}, "size of 0");
  left_out({{"type", "rect"}, {"size", "big"}}, "size that is not a number");
  left_out({{"type", "rect"}, {"rect", {{"aspect", -2}}}}, "aspect of -2");
  left_out({{"type", "rect"}, {"intensity", -1}}, "intensity of -1");
  left_out({{"type", "rect"}, {"intensity", "bright"}}, "intensity that is not a number");
  left_out({{"type", "rect"}, {"color", {1, -1, 1}}}, "colour");
  left_out({{"type", "rect"}, {"color", {1, 1}}}, "colour");
  left_out({{"type", "sphere"}}, "unknown type 'sphere'");
  left_out({{"size", 1}}, "unknown type ''");
  left_out({{"shape", "sphere"}, {"radius", -1}}, "radius of -1", khr_area);
  left_out({{"shape", "rect"}, {"width", 0}}, "width of 0", khr_area);
  left_out({{"shape", "sphere"}, {"radius", 1e30}}, "intensity", khr_area);

  LightFile flat, missing;
  flat.with(ext_area, {{"type", "disk"}}).turned({}, {1, 1, 0}).expect_left_out("flat");
  missing.with(ext_area, {{"type", "disk"}});
  missing.node()["extensions"][ext_area]["light"] = 7;
  missing.expect_left_out("light 7");
}

TEST(ImportAreaLight, LargeWholeNumbersAreNotCutOff) {
  LightFile file;
  EXPECT_EQ(file.with(ext_area, {{"type", "disk"}, {"intensity", 5000000000}}).light().intensity,
            5e9f);
}

TEST(ImportAreaLight, AFileMayRequireIt) {
  LightFile file;
  file.with(ext_area, {{"type", "disk"}});
  file.json()["extensionsRequired"] = {ext_area};
  EXPECT_EQ(file.light().type, Light::Type::disk);
}

TEST(ImportStandIn, AMarkedMeshShowsALight) {
  LightFile file;
  file.with(ext_area, {{"type", "rect"}});
  file.node()["mesh"] = 0;
  for (const json& yes : {json(true), json(1)}) {
    file.node()["extras"]["asos_light_fallback"] = yes;
    const Scene scene = file.load();
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_FALSE(scene.instances[0].shows_light);
    EXPECT_TRUE(scene.instances[1].shows_light);
    EXPECT_EQ(scene.lights.size(), 1u);
  }
  file.node()["extras"]["asos_light_fallback"] = false;
  EXPECT_FALSE(file.load().instances[1].shows_light);
}

}  // namespace
}  // namespace asos
