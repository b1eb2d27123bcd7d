#include "renderer/lights/emitters.h"
#include "tests/renderer/lights/emitter_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace asos::emitters_curved_test {
namespace {

using std::numbers::pi;
using test::add_soup;
using test::area_of;
using test::glow;
using test::plain_emission;
using test::total_flux;
using Soup = std::vector<std::array<glm::vec3, 3>>;

TEST(EmissiveLights, ABulbIsABallOfItsArea) {
  for (const int rings : {6, 40}) {
    World world;
    test::add_sphere(world, {3, 1, -2}, 0.5f, rings, glow({2, 1, 0}));
    const std::vector<Light> lights = emissive_lights(world, plain_emission);
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].type, Light::Type::point);
    const double area = area_of(world, 0);
    EXPECT_NEAR(4.0 * pi * lights[0].radius * lights[0].radius, area, 1e-9);
    EXPECT_NEAR(glm::distance(lights[0].position, {3, 1, -2}), 0.0, 1e-5);
    EXPECT_EQ(lights[0].color, glm::vec3(1, 0.5f, 0));
    EXPECT_NEAR(total_flux(lights, {3, 1, -2}, 2.0), 2.0 * pi * area, 0.01 * 2.0 * pi * area);
  }
}

TEST(EmissiveLights, ALongTubeIsALineOfItsPower) {
  for (const bool ends : {false, true}) {
    World world;
    add_soup(world, test::cylinder(0.05f, 2.0f, 24, ends), glow(glm::vec3(3)));
    const std::vector<Light> lights = emissive_lights(world, plain_emission);
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_EQ(lights[0].type, Light::Type::linear);
    EXPECT_NEAR(glm::length(lights[0].half_u), 1.0, 1e-4);
    EXPECT_NEAR(std::abs(lights[0].half_u.y), 1.0, 1e-4);
    EXPECT_NEAR(glm::length(lights[0].position), 0.0, 1e-4);
    const double area = area_of(world, 0);
    EXPECT_NEAR(lights[0].intensity, 3.0 * area / pi, 1e-5);
    EXPECT_NEAR(total_flux(lights, glm::dvec3(0), 3.0), 3.0 * pi * area, 0.01 * 3.0 * pi * area);
  }
}

// A receiver next to the middle of a tube gets the same light as from the cylinder itself.
TEST(EmissiveLights, ATubeShinesSidewaysAsItsSurfaceDoes) {
  World world;
  add_soup(world, test::cylinder(0.02f, 2.0f, 64, false), glow(glm::vec3(1)));
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  ASSERT_EQ(lights.size(), 1u);
  const Receiver beside{{1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}};
  // Integrates along the triangles' strips.
  double expected = 0.0;
  const Soup soup = test::cylinder(0.02f, 2.0f, 64, false);
  constexpr int cuts = 200;
  for (const auto& t : soup) {
    const glm::dvec3 across =
        glm::cross(glm::dvec3(t[1]) - glm::dvec3(t[0]), glm::dvec3(t[2]) - glm::dvec3(t[0]));
    const glm::dvec3 normal = glm::normalize(across);
    for (int k = 0; k < cuts; ++k) {
      // A triangle is half of a strip, which is divided into equal parts.
      const double y = -1.0 + 2.0 * (k + 0.5) / cuts;
      const glm::dvec3 p(0.02 * normal.x, y, 0.02 * normal.z);
      const glm::dvec3 d = beside.position - p;
      const double distance = glm::length(d);
      const double cosines = std::max(0.0, glm::dot(normal, d)) * std::max(0.0, d.x);
      expected += 0.5 * glm::length(across) / cuts * cosines / std::pow(distance, 4);
    }
  }
  EXPECT_NEAR(unshadowed_irradiance(prepare_light(lights[0]), beside).r, expected, 0.01 * expected);
}

TEST(EmissiveLights, WhatIsCurvedBecomesAFewRectanglesOfItsPower) {
  // The upper half of a sphere, a curved strip and a ring: neither spheres nor tubes.
  for (int shape = 0; shape < 3; ++shape) {
    Soup soup;
    const auto on = [&](double u, double v) {
      u *= 2.0 * pi;
      if (shape == 0) {
        const double theta = 0.5 * pi * v;
        return glm::vec3(std::sin(theta) * std::cos(u), std::cos(theta),
                         -std::sin(theta) * std::sin(u));
      }
      if (shape == 1) return glm::vec3(std::cos(0.5 * u), v, -std::sin(0.5 * u));
      const double phi = 2.0 * pi * v;
      const double r = 1.0 + 0.1 * std::cos(phi);
      return glm::vec3(r * std::cos(u), -0.1 * std::sin(phi), -r * std::sin(u));
    };
    constexpr int n = 40;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const auto corner = [&](int a, int b) {
          const int around = shape == 1 ? i + a : (i + a) % n;
          const int along = shape == 2 ? (k + b) % n : k + b;
          return on(double(around) / n, double(along) / n);
        };
        soup.push_back({corner(0, 1), corner(1, 1), corner(1, 0)});
        soup.push_back({corner(0, 1), corner(1, 0), corner(0, 0)});
        if (shape == 1) {
          for (std::size_t t = soup.size() - 2; t < soup.size(); ++t)
            std::swap(soup[t][1], soup[t][2]);
        }
      }
    }
    World world;
    add_soup(world, soup, glow(glm::vec3(2)));
    const std::vector<Light> lights = emissive_lights(world, plain_emission);
    EXPECT_GE(lights.size(), 3u) << shape;
    EXPECT_LE(lights.size(), max_lights_of_curved_piece) << shape;
    double areas = 0.0;
    for (const Light& light : lights) {
      EXPECT_EQ(light.type, Light::Type::rectangle);
      areas += prepare_light(light).area;
    }
    const double area = area_of(world, 0);
    EXPECT_NEAR(areas, area, 1e-3 * area) << shape;
    EXPECT_NEAR(total_flux(lights, glm::dvec3(0), 4.0), 2.0 * pi * area, 0.01 * 2.0 * pi * area)
        << shape;
  }
}

TEST(EmissiveLights, AThousandLampsAreAtMost64LightsOfTheirPower) {
  for (const bool cubes : {false, true}) {
    Soup soup;
    for (int i = 0; i < 1000; ++i) {
      const glm::vec3 corner(0.1f * static_cast<float>(i % 40), 0.1f * static_cast<float>(i / 40),
                             0);
      if (cubes) {
        test::add_box(soup, corner, glm::vec3(0.02f));
      } else {
        test::add_square(soup, corner, {0.02f, 0, 0}, {0, 0.02f, 0});
      }
    }
    World world;
    add_soup(world, soup, glow(glm::vec3(50)));
    const std::vector<Light> lights = emissive_lights(world, plain_emission);
    EXPECT_LE(lights.size(), max_lights_of_part);
    EXPECT_GT(lights.size(), max_lights_of_part / 2);
    const double power = 50.0 * pi * area_of(world, 0);
    EXPECT_NEAR(total_flux(lights, {2, 1.25, 0}, 10.0), power, 0.01 * power);
    // A surface near the field gets the same light as from all lamps.
    const Receiver near{{2, 1.25, 1.5}, {0, 0, -1}, {0, 0, -1}};
    double merged = 0.0;
    for (const Light& light : lights) merged += unshadowed_irradiance(prepare_light(light), near).r;
    double each = 0.0;
    for (const auto& t : soup) {
      const glm::dvec3 a(t[0]);
      const glm::dvec3 across = 0.5 * glm::cross(glm::dvec3(t[1]) - a, glm::dvec3(t[2]) - a);
      const glm::dvec3 d = near.position - (a + glm::dvec3(t[1]) + glm::dvec3(t[2])) / 3.0;
      each += 50.0 * std::max(0.0, glm::dot(across, d)) * d.z / std::pow(glm::length(d), 4);
    }
    // A cube has a larger or smaller outline than the sphere that replaces it.
    EXPECT_NEAR(merged, each, (cubes ? 0.3 : 0.02) * each);
  }
}

TEST(EmissiveLights, TwentyLampCubesStayWithinTheLimitAndKeepTheirPower) {
  Soup soup;
  for (int i = 0; i < 20; ++i)
    test::add_box(soup, {static_cast<float>(i), 0, 0},
                  glm::vec3(0.1f + 0.01f * static_cast<float>(i)));
  World world;
  add_soup(world, soup, glow(glm::vec3(1)));
  const std::vector<Light> lights = emissive_lights(world, plain_emission);
  EXPECT_LE(lights.size(), max_lights_of_part);
  EXPECT_GE(std::count_if(lights.begin(), lights.end(),
                          [](const Light& l) { return l.type == Light::Type::rectangle; }),
            6 * 8)
      << "the brightest keep their faces";
  const double power = pi * area_of(world, 0);
  EXPECT_NEAR(total_flux(lights, {10, 0, 0}, 30.0), power, 0.01 * power);
}

// Arbitrary triangles: overlapping, folded, degenerate, large and small. They keep their power.
TEST(EmissiveLights, AnySoupKeepsItsPowerInFewFiniteLights) {
  std::mt19937 rng(5);
  for (int round = 0; round < 400; ++round) {
    std::uniform_int_distribution<int> grid(0, 2 + round % 4);
    const float scale = std::pow(10.0f, static_cast<float>(round % 25 - 10));
    Soup soup(1 + static_cast<std::size_t>(rng() % 60));
    for (auto& t : soup) {
      for (glm::vec3& p : t) {
        p = scale * glm::vec3(grid(rng), grid(rng), round % 3 == 0 ? 0 : grid(rng));
      }
    }
    World world;
    add_soup(world, soup, glow(glm::vec3(2)));
    const std::vector<Light> lights = emissive_lights(world, plain_emission);
    EXPECT_LE(lights.size(), max_lights_of_part);
    for (const Light& light : lights) {
      EXPECT_GT(light.intensity, 0.0f);
      EXPECT_TRUE(std::isfinite(light.intensity + light.radius + light.position.x));
      EXPECT_TRUE(std::isfinite(glm::length(light.half_u) + glm::length(light.half_v)));
      EXPECT_NEAR(glm::length(light.direction), 1.0, 1e-9);
    }
    const double area = area_of(world, 0);
    const double power = mean_irradiance(lights, scale) * 4.0 * pi * scale * scale;
    EXPECT_NEAR(power, 2.0 * pi * area, 0.01 * 2.0 * pi * area) << "round " << round;
  }
}

/// A quad of 2 x 1 with an emissive texture of 64 x 32 texels, whose values come from the callback.
World screen() {
  World world;
  Material material = glow(glm::vec3(1));
  Image image{.width = 64, .height = 32};
  image.rgba.own().assign(4 * 64 * 32, 255);
  material.emissive_texture.texture = test::add_texture(world, image, Wrap::repeat, Filter::linear);
  test::add_quad(world, {0, 0, 0}, {2, 0, 0}, {0, 1, 0}, material);
  return world;
}

glm::vec2 uv_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const glm::uvec3 t = world.triangles[triangle];
  const auto& uv = world.texcoords[0];
  return (1.0f - b1 - b2) * uv[t.x] + b1 * uv[t.y] + b2 * uv[t.z];
}

TEST(EmissiveLights, TexturesAreAveragedByArea) {
  const World world = screen();
  const EmissionAt ramp = [](const World& w, std::uint32_t t, float b1, float b2) {
    const glm::vec2 uv = uv_at(w, t, b1, b2);
    return glm::vec3(uv.x, uv.x * uv.y, uv.y > 0.5f ? 1.0f : 0.0f);
  };
  const std::vector<Light> lights = emissive_lights(world, ramp);
  ASSERT_EQ(lights.size(), max_lights_of_curved_piece);
  glm::vec3 radiance(0.0f);
  for (const Light& light : lights) {
    const double area = 4.0 * glm::length(light.half_u) * glm::length(light.half_v);
    radiance += static_cast<float>(area / 2.0) * light.color * light.intensity;
  }
  EXPECT_NEAR(radiance.r, 0.5f, 0.005f);
  EXPECT_NEAR(radiance.g, 0.25f, 0.005f);
  EXPECT_NEAR(radiance.b, 0.5f, 0.02f);
  for (const Light& light : lights)
    EXPECT_EQ(std::max({light.color.r, light.color.g, light.color.b}), 1.0f);
}

TEST(EmissiveLights, BlackTexturesGiveNoLight) {
  const World world = screen();
  const EmissionAt noise = [](const World& w, std::uint32_t t, float b1, float b2) {
    return glm::vec3(0.003f * uv_at(w, t, b1, b2).x);
  };
  EXPECT_TRUE(emissive_lights(world, noise).empty());
  const EmissionAt one_bad_texel = [](const World& w, std::uint32_t t, float b1, float b2) {
    const bool bad = t == 0 && glm::length(uv_at(w, t, b1, b2) - glm::vec2(0.75f, 0.25f)) < 0.05f;
    return glm::vec3(bad ? std::numeric_limits<float>::quiet_NaN() : 1.0f);
  };
  // The triangle with a NaN mean is skipped, the other one emits.
  const std::vector<Light> lights = emissive_lights(world, one_bad_texel);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_NEAR(prepare_light(lights[0]).area, 1.0, 1e-6);
  EXPECT_NEAR(lights[0].intensity, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace asos::emitters_curved_test
