#include "renderer/gltf/validate_light.h"
#include "renderer/scene/builtin.h"
#include "renderer/scene/builtin/scene_assembler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

using builtin::SceneAssembler;

Scene make(const std::string& name) {
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (scene.name == name) return scene.make();
  }
  ADD_FAILURE() << "no built-in scene is called " << name;
  return {};
}

std::vector<Light> lights_of(const Scene& scene, Light::Type type) {
  std::vector<Light> found;
  std::copy_if(scene.lights.begin(), scene.lights.end(), std::back_inserter(found),
               [type](const Light& light) { return light.type == type; });
  return found;
}

/// Illuminance in lux of a rectangle at `p` on a surface with unit `normal`, summed over small
/// pieces by the inverse square and both cosines.
double illuminance(const Light& light, glm::dvec3 p, glm::dvec3 normal) {
  constexpr int n = 400;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const double u = (2 * i + 1.0) / n - 1.0, v = (2 * k + 1.0) / n - 1.0;
      const glm::dvec3 way = light.position + u * light.half_u + v * light.half_v - p;
      const double d2 = glm::dot(way, way);
      sum += std::max(0.0, glm::dot(way, normal)) * std::max(0.0, -glm::dot(way, light.direction)) /
             (d2 * d2);
    }
  }
  const double area = 4.0 * glm::length(light.half_u) * glm::length(light.half_v);
  return static_cast<double>(light.intensity) * sum * area / (n * n);
}

TEST(BuiltinLights, OfEverySceneAreWithoutFault) {
  for (const BuiltinScene& scene : builtin_scenes()) {
    for (const Light& light : scene.make().lights) {
      EXPECT_EQ(gltf::validate_light(light), "") << scene.name << ": " << light.name;
    }
  }
}

TEST(BuiltinLights, IlluminanceBeforeAPanelIsItsIntegral) {
  for (const glm::dvec2 size : {glm::dvec2(0.01, 0.02), glm::dvec2(1, 1), glm::dvec2(3, 0.5)}) {
    SceneAssembler stage("test");
    stage.panel("panel", {1, 2, 3}, {1, 2, 5}, size, 0xffffff, 1.0f);
    const Light light = stage.take().lights[0];
    EXPECT_NEAR(illuminance(light, {1, 2, 5}, {0, 0, -1}) / builtin::illuminance_before(size, 2.0),
                1.0, 1e-5);
  }
  // An endless panel fills half of all directions: pi lux per cd/m².
  EXPECT_NEAR(builtin::illuminance_before(glm::dvec2(1e9), 1.0), 3.14159265358979, 1e-8);
}

TEST(BuiltinLights, StagesShapesAreWhatTheySay) {
  SceneAssembler stage("test");
  stage.ball("ball", {1, 2, 3}, 0.5, 0xffffff, 7.0f);
  stage.tube("tube", {1, 2, 3}, {1, 2, 7}, 0xffffff, 8.0f);
  stage.panel("panel", {0, 3, 0}, {4, 0, 0}, {2, 6}, 0xffffff, 9.0f);
  const std::vector<Light> lights = stage.take().lights;
  EXPECT_EQ(lights[0].type, Light::Type::point);
  EXPECT_EQ(lights[0].radius, 0.5);
  EXPECT_EQ(lights[1].type, Light::Type::linear);
  EXPECT_EQ(lights[1].position, glm::dvec3(1, 2, 5));
  EXPECT_EQ(lights[1].half_u, glm::dvec3(0, 0, 2));
  const Light& panel = lights[2];
  EXPECT_LT(glm::length(panel.direction - glm::dvec3(0.8, -0.6, 0)), 1e-15);
  EXPECT_LT(glm::length(panel.half_u - glm::dvec3(0, 0, 1)), 1e-15);
  EXPECT_LT(glm::length(panel.half_v - glm::dvec3(1.8, 2.4, 0)), 1e-15);
}

TEST(BuiltinLights, PanelsGiveTheSubjectTheLightOfASun) {
  for (const char* name : {"boxes", "mixed", "dense"}) {
    SCOPED_TRACE(name);
    const std::vector<Light> panels = lights_of(make(name), Light::Type::rectangle);
    ASSERT_EQ(panels.size(), 1u);
    const Light& panel = panels[0];
    // Everywhere on the subject, within three metres of the centre: three of 120 metres change the
    // light by a twentieth (inverse square).
    for (const glm::dvec3 p : {glm::dvec3(0, 0.6, 0), glm::dvec3(2, 0, 0), glm::dvec3(-2, 2, 0)}) {
      EXPECT_NEAR(illuminance(panel, p, -panel.direction), 3.1, 3.1 / 20.0);
    }
    const double width = 2.0 * glm::length(panel.half_u), distance = glm::length(panel.position);
    EXPECT_GT(width / distance, 0.25);
    EXPECT_LT(width / distance, 0.34);
  }
}

TEST(BuiltinLights, OfficesPanelIsSeenAndHangsFreeOfWhatOneSees) {
  const Scene scene = make("office");
  const std::vector<Light> panels = lights_of(scene, Light::Type::rectangle);
  ASSERT_EQ(panels.size(), 1u);
  int shown = 0, panel = 0;
  for (const Instance& instance : scene.instances) {
    if (!instance.shows_light) continue;
    ++shown;
    if (instance.name != "light panel") continue;
    ++panel;
    const Mesh& mesh = scene.meshes.at(instance.mesh);
    EXPECT_GT(scene.materials.at(mesh.material).emissive_strength, 1.0f);
    glm::vec3 lo(1e9f), hi(-1e9f);
    for (const glm::vec3 p : mesh.positions) lo = glm::min(lo, p), hi = glm::max(hi, p);
    EXPECT_LT(panels[0].position.y, lo.y);
    EXPECT_GT(panels[0].position.y, lo.y - 0.01);
    EXPECT_NEAR(hi.x - lo.x, 2.0 * glm::length(panels[0].half_u), 1e-5);
    EXPECT_NEAR(hi.z - lo.z, 2.0 * glm::length(panels[0].half_v), 1e-5);
  }
  EXPECT_EQ(panel, 1);
  // The sky's screen and the monitor's picture are emissive, too, but no lights.
  EXPECT_EQ(shown, 3);
}

TEST(BuiltinLights, SunsOverHouseAndFenceHaveTheSunsSize) {
  for (const char* name : {"house", "fence"}) {
    const Scene scene = make(name);
    EXPECT_EQ(
        std::count_if(scene.lights.begin(), scene.lights.end(),
                      [](const Light& light) { return light.angular_diameter_rad == 0.0093; }),
        1);
  }
}

TEST(BuiltinLights, PrimitivesDifferInTheirMainLightOnly) {
  const Scene point = make("primitives");
  const glm::dvec3 down(0, -1, 0), up(0, 1, 0);
  const Light& lamp = point.lights.at(0);
  const double d = glm::length(lamp.position);
  const double lux = static_cast<double>(lamp.intensity) * lamp.position.y / (d * d * d);
  for (const char* name : {"primitives-ball", "primitives-linear", "primitives-rectangle"}) {
    SCOPED_TRACE(name);
    const Scene scene = make(name);
    ASSERT_EQ(scene.meshes.size(), point.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      EXPECT_EQ(scene.meshes[i].positions, point.meshes[i].positions);
    }
    ASSERT_EQ(scene.lights.size(), point.lights.size());
    EXPECT_EQ(scene.lights[0].position, lamp.position);
    EXPECT_EQ(scene.lights[0].color, lamp.color);
    for (std::size_t i = 1; i < scene.lights.size(); ++i) {
      EXPECT_EQ(scene.lights[i].direction, point.lights[i].direction);
      EXPECT_EQ(scene.lights[i].intensity, point.lights[i].intensity);
    }
  }
  EXPECT_EQ(make("primitives-ball").lights[0].radius, 1.0);
  EXPECT_EQ(make("primitives-ball").lights[0].intensity, lamp.intensity);
  EXPECT_EQ(make("primitives-linear").lights[0].half_u, glm::dvec3(1.25, 0, 0));
  EXPECT_EQ(make("primitives-linear").lights[0].intensity, lamp.intensity);
  const Light rectangle = make("primitives-rectangle").lights[0];
  EXPECT_EQ(rectangle.direction, down);
  EXPECT_NEAR(illuminance(rectangle, glm::dvec3(0.0), up) / lux, 1.0, 0.02);
}

TEST(BuiltinLights, NeonShinesByItsMeshesAndTheMoon) {
  const Scene scene = make("neon");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].type, Light::Type::directional);
  EXPECT_LT(scene.lights[0].intensity, 0.3f);
  int shining = 0, shown = 0;
  for (const Instance& instance : scene.instances) {
    if (instance.shows_light) ++shown;
    if (scene.materials.at(scene.meshes.at(instance.mesh).material).emissive_strength > 1.0f &&
        !instance.shows_light)
      ++shining;
  }
  EXPECT_GE(shining, 5) << "four words and the bulbs";
  EXPECT_EQ(shown, 1) << "the sky is no light";
}

TEST(BuiltinWheel, HasItsCabinsOnTheRimAndUpright) {
  const Scene scene = make("wheel");
  int cabins = 0;
  for (const Instance& instance : scene.instances) {
    if (!instance.name.starts_with("cabin body")) continue;
    ++cabins;
    const glm::dvec3 pin(instance.world_from_mesh[3]);
    EXPECT_NEAR(glm::distance(pin, glm::dvec3(0.0, 9.4, 0.0)), 7.6, 1e-5) << instance.name;
    EXPECT_EQ(glm::dmat3(instance.world_from_mesh), glm::dmat3(1.0)) << instance.name;
  }
  EXPECT_EQ(cabins, 12);
}

}  // namespace
}  // namespace asos
