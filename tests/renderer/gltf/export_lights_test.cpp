#include "renderer/gltf/load.h"
#include "renderer/gltf/validate_light.h"
#include "tests/renderer/gltf/light_checks.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <map>

namespace asos {
namespace {

using nlohmann::json;
using test::expect_equal;
using test::TemporaryFolder;

/// Three axes at right angles, aligned with nothing.
struct Axes {
  glm::dvec3 u = glm::normalize(glm::dvec3(1, -2, 0.5));
  glm::dvec3 v = glm::normalize(glm::cross(glm::dvec3(0.3, 1, 2), u));
  glm::dvec3 direction = -glm::cross(u, v);
};

Light light_of(Light::Type type, const char* name) {
  const Axes axes;
  Light light;
  light.name = name;
  light.type = type;
  light.color = {2.0f, 0.5f, 0.1f};
  light.intensity = 12.3f;
  light.position = {100.25, -3.5, 7.125};
  light.direction = axes.direction;
  return light;
}

/// A polygon with a notch and a hole in the plane of u and v; it emits against u x v.
Light polygon() {
  Light light = light_of(Light::Type::polygon, "polygon");
  const Axes axes;
  const auto at = [&](double x, double y) { return light.position + x * axes.u + y * axes.v; };
  light.outlines = {{at(-2, -2), at(-2, 2), at(0, 0.5), at(2, 2), at(2, -2)},
                    {at(-1, -1), at(1, -1), at(1, 0)}};
  light.two_sided = true;
  return light;
}

/// A light of each kind.
Scene lit_scene() {
  const Axes axes;
  Scene scene;
  scene.meshes = {
      {"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {}, {}, {{0, 1, 2}}, {}, {}, -1}};
  scene.meshes[0].normals.assign(3, {0, 0, 1});
  scene.instances = {{"seen", 0, glm::dmat4(1.0)}, {"shown", 0, glm::dmat4(1.0), true}};
  Light ball = light_of(Light::Type::point, "ball");
  ball.radius = 0.3;
  Light spot = light_of(Light::Type::spot, "spot");
  spot.radius = 0.1;
  Light sun = light_of(Light::Type::directional, "sun");
  sun.angular_diameter_rad = 0.0093;
  Light linear = light_of(Light::Type::linear, "linear");
  linear.half_u = {0.1, 0.7, -3.3};
  linear.casts_shadows = false;
  linear.radius = 0.04;
  Light rectangle = light_of(Light::Type::rectangle, "rectangle");
  rectangle.half_u = 1.7 * axes.u;
  rectangle.half_v = 0.3 * axes.v;
  Light disk = light_of(Light::Type::disk, "disk");
  disk.radius = 0.7;
  disk.casts_shadows = false;
  Light both = rectangle;
  both.name = "two-sided";
  both.two_sided = true;
  scene.lights = {rectangle, ball, polygon(),
                  spot,      disk, linear,
                  sun,       both, light_of(Light::Type::point, "point")};
  return scene;
}

json exported(const Scene& scene) {
  const TemporaryFolder folder;
  const std::string path = folder.file("lights.gltf");
  const Result<void> done = export_gltf(scene, path);
  if (!done) throw std::runtime_error(done.error().message());
  std::ifstream in(path);
  return json::parse(in);
}

Scene imported(const json& root) {
  const TemporaryFolder folder;
  Result<Scene> scene = import_gltf(folder.write("lights.gltf", root.dump()));
  if (!scene) throw std::runtime_error(scene.error().message());
  return std::move(*scene);
}

TEST(ExportLights, EveryKindComesBackAsItWas) {
  const Scene scene = lit_scene();
  const Scene back = imported(exported(scene));
  EXPECT_EQ(back.notes.warnings, std::vector<std::string>());
  EXPECT_TRUE(back.notes.unsupported_extensions.empty());
  ASSERT_EQ(back.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    expect_equal(scene.lights[i], back.lights[i]);
  }
  ASSERT_EQ(back.instances.size(), 2u);
  EXPECT_FALSE(back.instances[0].shows_light);
  EXPECT_TRUE(back.instances[1].shows_light);
}

TEST(ExportLights, RequiresNoExtension) {
  const json root = exported(lit_scene());
  EXPECT_FALSE(root.contains("extensionsRequired"));
  EXPECT_EQ(root["extensionsUsed"], (json{"EXT_lights_area", "KHR_lights_punctual"}));
  for (const json& light : root["extensions"]["KHR_lights_punctual"]["lights"]) {
    const std::string type = light["type"];
    EXPECT_TRUE(type == "point" || type == "spot" || type == "directional") << type;
  }
  const json& areas = root["extensions"]["EXT_lights_area"]["lights"];
  ASSERT_EQ(areas.size(), 3u);
  for (const json& light : areas) {
    for (const char* name : {"type", "color", "intensity", "size"}) {
      EXPECT_TRUE(light.contains(name)) << name;
    }
    for (const json& channel : light["color"]) EXPECT_LE(channel.get<double>(), 1.0);
    EXPECT_EQ(light.contains("rect"), light["type"] == "rect");
    EXPECT_NEAR(light["intensity"].get<double>(), 2.0 * 12.3, 1e-5);
  }
  EXPECT_NEAR(areas[0]["size"].get<double>(), 0.6, 1e-15);
  EXPECT_NEAR(areas[0]["rect"]["aspect"].get<double>(), 1.7 / 0.3, 1e-14);
  EXPECT_EQ(areas[1]["size"].get<double>(), 1.4);
}

/// Programs without support for an extension may drop it and keep extras, or the reverse.
TEST(ExportLights, FlatLightsOutliveTheLossOfEitherDescription) {
  const Scene scene = lit_scene();
  json without_extension = exported(scene), without_extras = without_extension;
  without_extension["extensionsUsed"] = {"KHR_lights_punctual"};
  without_extension["extensions"].erase("EXT_lights_area");
  for (json& node : without_extension["nodes"]) {
    if (node.contains("extensions")) node["extensions"].erase("EXT_lights_area");
  }
  const Scene exact = imported(without_extension);
  ASSERT_EQ(exact.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    expect_equal(scene.lights[i], exact.lights[i]);
  }

  for (json& node : without_extras["nodes"]) node.erase("extras");
  std::map<std::string, Light> left;
  for (const Light& light : imported(without_extras).lights) left[light.name] = light;
  EXPECT_FALSE(left.contains("polygon"));
  EXPECT_FALSE(left.contains("linear"));
  EXPECT_EQ(left.at("ball").radius, 0.3);  // in the light's own extras
  const Light &was = scene.lights[0], &is = left.at("rectangle");
  test::expect_close(was.half_u, is.half_u);
  test::expect_close(was.half_v, is.half_v);
  test::expect_close(was.direction, is.direction);
  const glm::vec3 before = was.color * was.intensity, after = is.color * is.intensity;
  EXPECT_LT(glm::length(before - after), 1e-5f * glm::length(before));
}

/// Blender saves booleans as 0 and 1, and integers unchanged.
TEST(ExportLights, TruthValuesMayComeBackAsNumbers) {
  const Scene scene = lit_scene();
  json root = exported(scene);
  for (json& node : root["nodes"]) {
    if (!node.contains("extras")) continue;
    for (json* extras : {&node["extras"], &node["extras"]["asos_light"]}) {
      for (json& value : *extras) {
        if (value.is_boolean()) value = value.get<bool>() ? 1 : 0;
      }
    }
    if (node["extras"]["asos_light"].is_null()) node["extras"].erase("asos_light");
  }
  const Scene back = imported(root);
  EXPECT_EQ(back.notes.warnings, std::vector<std::string>());
  ASSERT_EQ(back.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    expect_equal(scene.lights[i], back.lights[i]);
  }
  EXPECT_TRUE(back.instances[1].shows_light);
}

TEST(ExportLights, ARectangleMayBeTurnedRoundAboutItsMiddle) {
  // A node's axes are right-handed; for a rectangle v and -v are equivalent.
  Scene scene = lit_scene();
  scene.lights = {scene.lights[0]};
  scene.lights[0].half_v *= -1.0;
  const Light back = imported(exported(scene)).lights.at(0);
  scene.lights[0].half_v *= -1.0;
  expect_equal(scene.lights[0], back);
}

TEST(ExportLights, BrokenOnesAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](std::size_t index, auto change, const std::string& words) {
    const TemporaryFolder folder;
    Scene scene = lit_scene();
    change(scene.lights[index]);
    const Result<void> result = export_gltf(scene, folder.file("broken.glb"));
    ASSERT_FALSE(result) << words;
    EXPECT_NE(result.error().reason.find(words), std::string::npos) << result.error().reason;
    EXPECT_NE(result.error().reason.find("'" + scene.lights[index].name + "'"), std::string::npos);
  };
  refused(
      0, [](Light& l) { l.half_u = glm::dvec3(0.0); }, "no length");
  refused(
      0, [&](Light& l) { l.half_v.y = nan; }, "no length");
  refused(
      0, [](Light& l) { l.half_v += 0.1 * l.half_u; }, "right angles");
  refused(
      0, [](Light& l) { l.direction = glm::normalize(l.half_u); }, "right angles");
  refused(
      0, [](Light& l) { l.direction *= 2.0; }, "unit length");
  refused(
      1, [](Light& l) { l.radius = -1.0; }, "radius");
  refused(
      1, [&](Light& l) { l.radius = nan; }, "radius");
  refused(
      2, [](Light& l) { l.outlines.clear(); }, "no outline");
  refused(
      2, [](Light& l) { l.outlines[1].pop_back(); }, "three corners");
  refused(
      2, [](Light& l) { l.outlines[0][1] += l.direction; }, "not flat");
  refused(
      2, [](Light& l) { l.direction *= -1.0; }, "counter-clockwise");
  refused(
      2, [&](Light& l) { l.outlines[0][3].z = nan; }, "not finite");
  refused(
      4, [](Light& l) { l.radius = 0.0; }, "radius");
  refused(
      5, [](Light& l) { l.half_u = glm::dvec3(0.0); }, "no length");
  refused(
      5, [](Light& l) { l.radius = -1.0; }, "radius");
  refused(
      5, [&](Light& l) { l.radius = nan; }, "radius");
  refused(
      6, [](Light& l) { l.angular_diameter_rad = 3.2; }, "angular diameter");
  refused(
      6, [&](Light& l) { l.angular_diameter_rad = nan; }, "angular diameter");
  refused(
      7, [&](Light& l) { l.position.x = nan; }, "position");
}

}  // namespace
}  // namespace asos
