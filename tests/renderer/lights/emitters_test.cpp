#include "renderer/lights/emitters.h"

#include "tests/renderer/lights/emitter_worlds.h"
#include "tests/support/quad_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos::emitters_test {
namespace {

using std::numbers::pi;
using test::add_quad;
using test::add_soup;
using test::area_of;
using test::glow;
using test::plain_emission;
using test::total_flux;
using Soup = std::vector<std::array<glm::vec3, 3>>;

World quad_world(const Material& material) {
  World world;
  add_quad(world, {5, 0, 0}, {1, 0, 0}, {0, 0, 1}, test::matte(glm::vec3(1)));
  add_quad(world, {1, 2, 3}, {2, 0, 0}, {0, 3, 0}, material);
  return world;
}

TEST(EmissiveLights, AQuadIsARectangle) {
  Material material = glow({0.5f, 2.0f, 1.0f});
  material.emissive_strength = 3.0f;
  const std::vector<Light> lights = emissive_lights(quad_world(material), plain_emission);
  ASSERT_EQ(lights.size(), 1u);
  const Light& light = lights[0];
  EXPECT_EQ(light.type, Light::Type::rectangle);
  EXPECT_EQ(light.own_part, 1);
  EXPECT_TRUE(light.casts_shadows);
  EXPECT_FALSE(light.two_sided);
  EXPECT_FLOAT_EQ(light.intensity, 6.0f);
  EXPECT_EQ(light.color, glm::vec3(0.25f, 1.0f, 0.5f));
  EXPECT_NEAR(glm::distance(light.position, {2, 3.5, 3}), 0.0, 1e-12);
  EXPECT_NEAR(glm::distance(light.direction, {0, 0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(prepare_light(light).area, 6.0, 1e-12);
  EXPECT_NEAR(glm::distance(prepare_light(light).towards, {0, 0, 1}), 0.0, 1e-12);
}

TEST(EmissiveLights, OnlyWhatShinesAndHasAreaGivesLights) {
  const auto count = [](const Material& material) {
    return emissive_lights(quad_world(material), plain_emission).size();
  };
  Material material = glow(glm::vec3(1e-20f));
  EXPECT_EQ(count(material), 1u) << "dim, but somebody may raise the exposure";
  material.emissive_strength = 0.0f;
  EXPECT_EQ(count(material), 0u);
  material = glow(glm::vec3(1));
  material.unlit = true;
  EXPECT_EQ(count(material), 0u);
  material = glow(glm::vec3(std::numeric_limits<float>::infinity()));
  EXPECT_EQ(count(material), 0u);
  material = glow({1, std::numeric_limits<float>::quiet_NaN(), 0});
  EXPECT_EQ(count(material), 0u);

  World shown = quad_world(glow(glm::vec3(1)));
  shown.parts[1].shows_light = true;
  EXPECT_TRUE(emissive_lights(shown, plain_emission).empty());

  World flat;
  add_soup(flat, {{glm::vec3(0), glm::vec3(1), glm::vec3(2)}, {}}, glow(glm::vec3(1)));
  EXPECT_TRUE(emissive_lights(flat, plain_emission).empty());
}

TEST(EmissiveLights, TheFrontShinesAndBothSidesIfDoubleSided) {
  World world;
  add_quad(world, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, glow(glm::vec3(1)));
  Material both = glow(glm::vec3(1));
  both.double_sided = true;
  add_quad(world, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, both);
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_NEAR(lights[0].direction.z, -1.0, 1e-12);
  EXPECT_FALSE(lights[0].two_sided);
  EXPECT_TRUE(lights[1].two_sided);
  // Behind the lights, only the two-sided one shines.
  const Receiver behind{{0.5, 0.5, 2}, {0, 0, -1}, {0, 0, -1}};
  EXPECT_EQ(unshadowed_irradiance(prepare_light(lights[0]), behind).r, 0.0f);
  EXPECT_GT(unshadowed_irradiance(prepare_light(lights[1]), behind).r, 0.1f);
}

TEST(EmissiveLights, AMirroredInstanceKeepsItsFrontInFront) {
  Scene scene;
  scene.meshes.push_back(test::quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  scene.materials.push_back(glow(glm::vec3(1)));
  for (const glm::dvec3 scale : {glm::dvec3(-1, 1, 1), glm::dvec3(1, 1, -1)}) {
    Instance instance{.mesh = 0};
    for (int i = 0; i < 3; ++i) instance.world_from_mesh[i][i] = scale[i];
    scene.instances.push_back(instance);
  }
  const std::vector<Light> lights = emissive_lights(flatten(scene).value().world, plain_emission);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_NEAR(lights[0].direction.z, 1.0, 1e-12);
  EXPECT_NEAR(lights[1].direction.z, -1.0, 1e-12);
}

TEST(EmissiveLights, AFrameHasAnOuterOutlineAndAHole) {
  // Eight squares around a missing one, rotated and shifted, with unshared vertices.
  Soup soup;
  const glm::vec3 a = 2.0f * glm::normalize(glm::vec3(1, 2, 0));
  const glm::vec3 b = 2.0f * glm::normalize(glm::vec3(-2, 1, 1));
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;
    const auto x = static_cast<float>(i % 3);
    const auto y = static_cast<float>(i / 3);
    test::add_square(soup, glm::vec3(7, -3, 2) + x * a + y * b, a, b);
  }
  World world;
  add_soup(world, soup, glow(glm::vec3(4)));
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  ASSERT_EQ(lights.size(), 1u);
  ASSERT_EQ(lights[0].type, Light::Type::polygon);
  ASSERT_EQ(lights[0].outlines.size(), 2u);
  double areas[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<glm::dvec3>& o = lights[0].outlines[k];
    ASSERT_EQ(o.size(), 4u) << "corners on straight edges are merged";
    const glm::dvec3 twice =
        glm::cross(o[1] - o[0], o[2] - o[0]) + glm::cross(o[2] - o[0], o[3] - o[0]);
    areas[k] = 0.5 * glm::dot(twice, lights[0].direction);
  }
  EXPECT_NEAR(std::max(areas[0], areas[1]), 36.0, 1e-4);
  EXPECT_NEAR(std::min(areas[0], areas[1]), -4.0, 1e-4);
  EXPECT_NEAR(prepare_light(lights[0]).area, 32.0, 1e-4);
  EXPECT_NEAR(glm::dot(lights[0].direction, glm::normalize(glm::dvec3(glm::cross(a, b)))), 1.0,
              1e-9);
  EXPECT_NEAR(lights[0].intensity, 4.0f, 1e-4f);
}

TEST(EmissiveLights, SquaresThatTouchInACornerAreTwo) {
  Soup soup;
  test::add_square(soup, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  test::add_square(soup, {1, 1, 0}, {1, 0, 0}, {0, 1, 0});
  World world;
  add_soup(world, soup, glow(glm::vec3(1)));
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  ASSERT_EQ(lights.size(), 2u);
  for (const Light& light : lights) EXPECT_EQ(light.type, Light::Type::rectangle);
}

// Seven squares around a missing one: the hole touches the outer outline in a corner.
TEST(EmissiveLights, AnOutlineMayPassACornerTwice) {
  World joined;
  World single;
  Soup all;
  const float cells[][2] = {{0, 0}, {0, -1}, {1, -1}, {2, -1}, {2, 0}, {2, 1}, {1, 1}};
  for (const auto& cell : cells) {
    Soup one;
    test::add_square(one, {cell[0], cell[1], 0}, {1, 0, 0}, {0, 1, 0});
    all.insert(all.end(), one.begin(), one.end());
    add_soup(single, one, glow(glm::vec3(1)));
  }
  add_soup(joined, all, glow(glm::vec3(1)));
  const std::vector<Light> polygon = emissive_lights(joined, plain_emission);
  const std::vector<Light> squares = emissive_lights(single, plain_emission);
  ASSERT_EQ(polygon.size(), 1u);
  ASSERT_EQ(squares.size(), 7u);
  EXPECT_NEAR(prepare_light(polygon[0]).area, 7.0, 1e-9);
  for (const glm::dvec3 at : {glm::dvec3(1.5, 0.5, 0.2), glm::dvec3(0.5, 1.5, 0.3)}) {
    const Receiver receiver{at, {0, 0, -1}, {0, 0, -1}};
    double sum = 0.0;
    for (const Light& light : squares)
      sum += unshadowed_irradiance(prepare_light(light), receiver).r;
    EXPECT_NEAR(unshadowed_irradiance(prepare_light(polygon[0]), receiver).r, sum, 1e-5 * sum);
  }
}

TEST(EmissiveLights, ABoxShinesOutwardsWhicheverWayItIsWound) {
  for (const float height : {2.0f, 0.01f}) {
    for (const bool inside_out : {false, true}) {
      Soup soup;
      test::add_box(soup, {-1, 3, 4}, {3, height, 2});
      for (auto& t : soup) {
        if (inside_out) std::swap(t[1], t[2]);
      }
      Material material = glow(glm::vec3(1));
      material.double_sided = true;
      World world;
      add_soup(world, soup, material);
      const std::vector<Light> lights = emissive_lights(world, plain_emission);
      ASSERT_EQ(lights.size(), 6u) << height << inside_out;
      const glm::dvec3 middle(0.5, 3 + 0.5 * height, 5);
      for (const Light& light : lights) {
        EXPECT_EQ(light.type, Light::Type::rectangle);
        EXPECT_FALSE(light.two_sided) << "its back faces the inside";
        EXPECT_GT(glm::dot(light.direction, light.position - middle), 0.0);
      }
      EXPECT_NEAR(total_flux(lights, middle, 10.0), pi * area_of(world, 0),
                  0.01 * pi * area_of(world, 0));
    }
  }
}

TEST(EmissiveLights, ATableOfManyCornersIsADisk) {
  Soup soup;
  constexpr int sides = 200;
  for (int i = 0; i < sides; ++i) {
    const auto at = [](int k) {
      const float phi = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k % sides) / sides;
      return glm::vec3(2.0f * std::cos(phi), 1.0f, -2.0f * std::sin(phi));
    };
    soup.push_back({glm::vec3(0, 1, 0), at(i), at(i + 1)});
  }
  World world;
  add_soup(world, soup, glow(glm::vec3(1)));
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].type, Light::Type::disk);
  EXPECT_NEAR(pi * lights[0].radius * lights[0].radius, area_of(world, 0), 1e-5);
  EXPECT_NEAR(lights[0].direction.y, 1.0, 1e-9);
}

TEST(MeanIrradiance, IsThePowerOverTheSphere) {
  const std::vector<Light> lights = emissive_lights(quad_world(glow({1, 3, 2})), plain_emission);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_NEAR(mean_irradiance(lights, 5.0), pi * 3.0 * 6.0 / (4.0 * pi * 25.0), 1e-6);
  EXPECT_EQ(mean_irradiance(lights, 0.0), 0.0);
  EXPECT_EQ(mean_irradiance({}, 1.0), 0.0);
}

}  // namespace
}  // namespace asos::emitters_test
