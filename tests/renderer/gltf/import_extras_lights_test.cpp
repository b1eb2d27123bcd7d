#include "renderer/gltf/outlines.h"
#include "tests/renderer/gltf/light_checks.h"
#include "tests/renderer/gltf/light_file.h"

#include <gtest/gtest.h>

// Lights in a node's extras, for types that glTF lacks or other programs drop.

namespace asos {
namespace {

using nlohmann::json;
using test::expect_close;
using test::LightFile;

json linear() {
  return {{"type", "linear"}, {"intensity", 40}, {"from", {-1, 0, 0.5}}, {"to", {2, 0, 0.5}}};
}

/// A square of side 4 in the plane y = 1 that emits upwards, with a square hole of side 2.
json framed() {
  return {{"type", "polygon"},
          {"intensity", 3},
          {"corners", {-2, 1, 2, 2,  1, 2,  2, 1, -2, -2, 1, -2,  //
                       -1, 1, 1, -1, 1, -1, 1, 1, -1, 1,  1, 1}},
          {"outline_sizes", {4, 4}}};
}

TEST(ImportLinearLight, ItsEndsGoWhereItsNodePutsThem) {
  LightFile file;
  file.with_extras(linear());
  const Light plain = file.light();
  EXPECT_EQ(plain.type, Light::Type::linear);
  EXPECT_EQ(plain.name, "lamp");
  EXPECT_EQ(plain.intensity, 40.0f);
  EXPECT_EQ(plain.color, glm::vec3(1.0f));
  EXPECT_EQ(plain.half_u, glm::dvec3(1.5, 0, 0));
  EXPECT_EQ(plain.position, glm::dvec3(0.5, 0, 0.5));
  // Each end is a point, so non-uniform scale acts along the light; its intensity in candela does
  // not change.
  const Light placed = file.turned({10, 0, 0}, {2, 5, 7}).light();
  expect_close(placed.half_u, {0, 0, -3});
  expect_close(placed.position, {10 + 3.5, 0, -1});
  EXPECT_EQ(placed.intensity, 40.0f);
}

TEST(ImportLinearLight, RadiusMakesItACapsule) {
  LightFile file;
  json capsule = linear();
  capsule["radius"] = 0.1;
  file.with_extras(capsule);
  EXPECT_EQ(file.light().radius, 0.1);
  EXPECT_DOUBLE_EQ(file.turned({10, 0, 0}, {2, 5, 7}).light().radius, 0.7);
  capsule["radius"] = 0;
  EXPECT_EQ(LightFile().with_extras(capsule).light().radius, 0.0);
}

TEST(ImportLinearLight, BadOnesAreLeftOutByName) {
  const auto left_out = [](const char* name, const json& value, const std::string& words) {
    SCOPED_TRACE(value.dump());
    LightFile file;
    json light = linear();
    light[name] = value;
    file.with_extras(std::move(light)).expect_left_out(words);
  };
  left_out("from", {2, 0, 0.5}, "no length");
  left_out("from", {2, 0}, "ends");
  left_out("to", {2, 0, "1"}, "ends");
  left_out("to", 3, "ends");
  left_out("to", {1.7e308, 1.7e308, 0}, "no length");  // an infinite length
  left_out("radius", -0.1, "radius of -0.1");
  left_out("radius", "wide", "radius that is not a number");
  left_out("intensity", -1, "intensity");
  left_out("intensity", "40", "intensity");
  left_out("color", {1, 1, -1}, "colour");
  left_out("type", "lineal", "unknown type 'lineal'");
  LightFile no_intensity, no_object, flat;
  json dark = linear();
  dark.erase("intensity");
  no_intensity.with_extras(dark).expect_left_out("no intensity");
  no_object.with_extras(7).expect_left_out("not an object");
  flat.with_extras(linear()).turned({}, {0, 1, 1}).expect_left_out("no length");
}

TEST(ImportPolygonLight, ShinesToWhereItsOutlineRunsCounterClockwise) {
  LightFile file;
  const Light light = file.with_extras(framed()).light();
  EXPECT_EQ(light.type, Light::Type::polygon);
  expect_close(light.direction, {0, 1, 0});
  EXPECT_EQ(light.position.y, 1.0);
  ASSERT_EQ(light.outlines.size(), 2u);
  expect_close(light.outlines[0][0], {-2, 1, 2});
  expect_close(light.outlines[0][1], {2, 1, 2});
  // The hole was given clockwise, as it is stored; a counter-clockwise hole in the file gives the
  // same.
  json turned = framed();
  turned["corners"] = {-2, 1, 2, 2, 1, 2,  2,  1, -2, -2, 1, -2,
                       1,  1, 1, 1, 1, -1, -1, 1, -1, -1, 1, 1};
  LightFile other;
  const Light same = other.with_extras(turned).light();
  for (std::size_t i = 0; i < 4; ++i) expect_close(same.outlines[1][i], light.outlines[1][i]);
}

TEST(ImportPolygonLight, IsPlacedLikeAMeshMirrorsIncluded) {
  LightFile file;
  file.with_extras(framed());
  const Light placed = file.turned({0, 10, 0}, {1, 1, 3}).light();
  expect_close(placed.direction, {0, 1, 0});
  EXPECT_NEAR(placed.position.y, 11.0, 1e-12);
  expect_close(placed.outlines[0][0], {6, 11, 2});
  // After mirroring the front stays in front, as for a mesh.
  const Light mirrored = file.turned({0, 10, 0}, {-1, 1, 1}).light();
  expect_close(mirrored.direction, {0, 1, 0});
  const Light upside_down = file.turned({0, 10, 0}, {1, -1, 1}).light();
  expect_close(upside_down.direction, {0, -1, 0});
  EXPECT_NEAR(upside_down.position.y, 9.0, 1e-12);
  for (const Light* light : {&placed, &mirrored, &upside_down}) {
    const auto flat = gltf::flatten_outlines(light->outlines);
    ASSERT_TRUE(flat) << flat.error();
    expect_close(flat->normal, light->direction);
    expect_close(flat->outlines[1][0], light->outlines[1][0]);
  }
}

TEST(ImportPolygonLight, NearlyFlatOutlinesAreMadeFlat) {
  LightFile file;
  json light = framed();
  light.erase("outline_sizes");
  light["corners"] = {0, 0, 0, 1, 0, 1e-5, 1, 1, -1e-5, 0, 1, 1e-5};
  const Light flat = file.with_extras(light).light();
  for (const glm::dvec3 p : flat.outlines[0]) {
    EXPECT_NEAR(glm::dot(p - flat.position, flat.direction), 0.0, 1e-15);
    EXPECT_LT(std::abs(p.z), 2e-5);
  }
}

TEST(ImportPolygonLight, BadOnesAreLeftOutByName) {
  const auto left_out = [](const json& corners, const json& sizes, const std::string& words) {
    SCOPED_TRACE(words);
    LightFile file;
    json light = framed();
    light["corners"] = corners;
    light["outline_sizes"] = sizes;
    file.with_extras(std::move(light)).expect_left_out(words);
  };
  const json square = framed()["corners"];
  left_out({0, 0, 0, 1, 0, 0}, {2}, "three corners");
  left_out({0, 0, 0, 1, 0, 0, 1, 1}, {3}, "three numbers");
  left_out({0, 0, 0, 1, 0, 0, 1, 1, "0"}, {3}, "numbers");
  left_out("none", {3}, "numbers");
  left_out(json::array(), json::array(), "no list `corners`");
  left_out({0, 0, 0, 1, 0, 0, 2, 0, 0}, {3}, "without area");
  left_out({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5}, {4}, "not flat");
  left_out({0, 0, 0, 4, 0, 0, 1, 3, 0, 4, 3, 0, 0, 1, 0}, {5}, "cross");
  left_out({1e300, 0, 0, 0, 1e300, 0, 0, 0, 0}, {3}, "area");
  left_out(square, {4}, "count");
  left_out(square, {4, 5}, "count");
  left_out(square, {3.5, 4.5}, "count");
  left_out(square, {9, -1}, "count");
  left_out(square, "4", "outline sizes");
  json moved = square;
  for (std::size_t i = 12; i < 24; i += 3) moved[i] = moved[i].get<double>() + 10.0;
  left_out(moved, {4, 4}, "outside");
  json across = square;
  for (std::size_t i = 12; i < 24; i += 3) across[i] = across[i].get<double>() + 2.0;
  left_out(across, {4, 4}, "cross");
  LightFile flat;
  flat.with_extras(framed()).turned({}, {1, 1, 0}).expect_left_out("without area");
}

TEST(ImportFlatLight, ExtrasDescribeRectanglesAndDisks) {
  LightFile rect, disk;
  rect.with_extras({{"type", "rect"},
                    {"intensity", 5},
                    {"width", 3},
                    {"height", 1},
                    {"two_sided", 1},
                    {"casts_shadows", false}});
  const Light panel = rect.turned({1, 2, 3}, {1, 2, 1}).light();
  EXPECT_EQ(panel.type, Light::Type::rectangle);
  expect_close(panel.direction, {-1, 0, 0});
  expect_close(panel.half_u, {0, 0, -3});
  expect_close(panel.half_v, {0, 1, 0});
  EXPECT_TRUE(panel.two_sided);
  EXPECT_FALSE(panel.casts_shadows);
  disk.with_extras({{"type", "disk"}, {"intensity", 5}, {"radius", 0.75}});
  EXPECT_EQ(disk.light().radius, 0.75);

  const auto left_out = [](const json& light, const std::string& words) {
    LightFile file;
    file.with_extras(light).expect_left_out(words);
  };
  left_out({{"type", "rect"}, {"intensity", 5}, {"width", 3}}, "no height");
  left_out({{"type", "rect"}, {"intensity", 5}, {"width", 3}, {"height", 0}}, "height of 0");
  left_out({{"type", "disk"}, {"intensity", 5}}, "no radius");
  left_out({{"type", "disk"}, {"intensity", 5}, {"radius", "1"}}, "radius");
}

TEST(ImportFlatLight, ALightThatIsDescribedTwiceIsOneLight) {
  const json extension = {{"type", "rect"},
                          {"intensity", 20},
                          {"color", {1, 0.5, 0}},
                          {"size", 2},
                          {"rect", {{"aspect", 2}}}};
  json extras = {{"type", "rect"},    {"intensity", 10}, {"color", {2, 1, 0}},
                 {"two_sided", true}, {"width", 4},      {"height", 2}};
  LightFile file;
  file.with("EXT_lights_area", extension).with_extras(extras);
  const Light exact = file.light();
  EXPECT_EQ(exact.color, glm::vec3(2, 1, 0));
  EXPECT_EQ(exact.intensity, 10.0f);
  EXPECT_TRUE(exact.two_sided);

  // A program that only supports the extension has made the light smaller.
  extras["width"] = 5;
  file.with_extras(extras);
  const Scene scene = file.load();
  ASSERT_EQ(scene.lights.size(), 1u);
  expect_close(scene.lights[0].half_u, {2, 0, 0});
  EXPECT_EQ(scene.lights[0].intensity, 20.0f);
  EXPECT_TRUE(scene.lights[0].two_sided);
  LightFile::expect_warning(scene, "'lamp'");

  // If the extras are invalid, the extension counts.
  extras["width"] = -1;
  const Scene broken = file.with_extras(extras).load();
  ASSERT_EQ(broken.lights.size(), 1u);
  EXPECT_EQ(broken.lights[0].intensity, 20.0f);
  LightFile::expect_warning(broken, "width of -1");
}

TEST(ImportExtras, OtherProgramsExtrasSayNothing) {
  LightFile file;
  file.node()["extras"] = {{"radius", -5}, {"asos", {{"type", "linear"}}}, {"light", 3}};
  const Scene scene = file.load();
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_TRUE(scene.notes.warnings.empty());
}

}  // namespace
}  // namespace asos
