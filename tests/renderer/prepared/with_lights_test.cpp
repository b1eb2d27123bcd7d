#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace asos::with_lights_test {
namespace {

std::shared_ptr<const RenderScene> boxes(std::vector<Light> lights = {}) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    if (builtin.name != "boxes") continue;
    Scene scene = builtin.make();
    if (!lights.empty()) scene.lights = std::move(lights);
    return prepare(scene).value();
  }
  return nullptr;
}

std::vector<Light> other_lights() {
  Light ball = test::make_bulb({1, 4, 3}, 30.0f, 0.3);
  ball.name = "ball";
  const Light sun = test::make_sun(glm::normalize(glm::dvec3(-1, -2, -1)), 1.5f);
  return {ball, sun};
}

test::Picture picture_of(const RenderScene& scene) {
  const RenderSettings settings = test::make_settings(32, 24);
  return test::render_picture(scene, test::first_camera(scene.world(), 4.0 / 3.0), settings);
}

TEST(WithLights, GivesThePictureOfASceneWithThoseLights) {
  const auto before = boxes();
  const auto fresh = boxes(other_lights());
  std::vector<Light> lights = other_lights();
  for (Light& light : lights) light.position -= before->world().origin;
  const auto relit = with_lights(before, lights);
  ASSERT_TRUE(relit.has_value());
  EXPECT_EQ((*relit)->render_features, fresh->render_features);
  EXPECT_EQ((*relit)->geometry, before->geometry) << "nothing is rebuilt";
  EXPECT_EQ((*relit)->materials, before->materials);
  const test::Picture expected = picture_of(*fresh), got = picture_of(**relit);
  EXPECT_EQ(got.film.radiance, expected.film.radiance);
  EXPECT_NE(got.film.radiance, picture_of(*before).film.radiance);
}

TEST(WithLights, OutlivesTheSceneItCameFrom) {
  auto before = boxes();
  const auto film = picture_of(*before).film;
  std::vector<Light> lights = before->lights();
  auto relit = with_lights(with_lights(before, other_lights()).value(), lights).value();
  EXPECT_EQ(relit->own_lighting, before->lighting) << "the original scene is known";
  before.reset();
  EXPECT_EQ(picture_of(*relit).film.radiance, film.radiance);
}

// Every block has a shader, and a picture has thousands of blocks.
TEST(Lighting, IsPreparedOnceForAllShaders) {
  const auto scene = with_lights(boxes(), other_lights()).value();
  const View view(test::first_camera(scene->world(), 4.0 / 3.0), 32, 24);
  RenderSettings settings;
  for (const LightRule rule : {LightRule::physical, LightRule::published}) {
    settings.shadow.light_rule = rule;
    const Shader first = shader_of(*scene, settings, view);
    const Shader second = shader_of(*scene, settings, view);
    ASSERT_EQ(first.lights().size(), 2u);
    EXPECT_EQ(first.lights().data(), second.lights().data()) << "nothing is copied";
    EXPECT_EQ(first.lights().data(), scene->lighting->prepared(rule).data());
    for (const PreparedLight& light : first.lights()) EXPECT_EQ(light.rule, rule);
  }
}

TEST(WithLights, RefusesWhatIsNotFinite) {
  const auto scene = boxes();
  for (int broken = 0; broken < 4; ++broken) {
    std::vector<Light> lights = other_lights();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (broken == 0) lights[0].position.y = nan;
    if (broken == 1) lights[0].radius = std::numeric_limits<double>::infinity();
    if (broken == 2) lights[0].color.x = std::numeric_limits<float>::infinity();
    if (broken == 3) lights[0].own_part = 0;
    const auto relit = with_lights(scene, lights);
    ASSERT_FALSE(relit.has_value()) << broken;
    EXPECT_EQ(relit.error().subject, "light 'ball'");
  }
}

}  // namespace
}  // namespace asos::with_lights_test
