#include "renderer/shading/shade.h"
#include "renderer/shading/sky.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

// Straight transmission through surfaces, along rays to lights and to the viewer.

namespace asos::test::passage_test {
namespace {

Material glass(float thickness, glm::vec3 colour = glm::vec3(1.0f), float distance = 1.0f) {
  Material m = matte(glm::vec3(1.0f));
  m.roughness = 0.0f;
  m.transmission = 1.0f;
  m.volume.thickness = thickness;
  m.volume.attenuation_color = colour;
  m.volume.attenuation_distance = distance;
  return m;
}

/// A slab parallel to x and z between two heights, facing outwards.
void add_slab(World& world, float low, float high, const Material& m, float reach = 5.0f) {
  add_quad(world, {-reach, high, reach}, {2 * reach, 0, 0}, {0, 0, -2 * reach}, m);
  add_quad(world, {-reach, low, reach}, {0, 0, -2 * reach}, {2 * reach, 0, 0}, m);
}

RayScene rays_of(const World& world) {
  return RayScene::build(world, alpha_at, {}, {}, passage_at).value();
}

/// A ray upwards from a height at an angle, of this length.
Ray up_from(float height, double angle, float length) {
  return {
      .origin = {0.1f, height, 0.2f},
      .direction = {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0f},
      .t_far = length};
}

double left_of_fresnel(double angle) {
  return 0.96 * (1.0 - std::pow(1.0 - std::cos(angle), 5.0));
}

void expect_share(glm::vec3 found, glm::dvec3 expected, double relative, double place) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c], expected[c], relative * expected[c] + 1e-6) << place << ", colour " << c;
}

constexpr double colour[] = {0.25, 0.9, 0.5};

glm::dvec3 attenuated(double way, double distance) {
  return {std::pow(colour[0], way / distance), std::pow(colour[1], way / distance),
          std::pow(colour[2], way / distance)};
}

TEST(Passage, ThroughAPlateIsFresnelsTwiceAndBeersLaw) {
  for (const float scale : {1e-6f, 1.0f, 1e4f}) {
    World world;
    Material m = glass(1.0f, {0.25f, 0.9f, 0.5f}, 0.7f * scale);
    m.base_color = {0.9f, 0.8f, 1.0f, 1.0f};
    add_slab(world, 1.0f * scale, 1.4f * scale, m, 20.0f * scale);
    const RayScene rays = rays_of(world);
    for (const double angle : {0.0, 0.5, 1.0, 1.3}) {
      const double left = left_of_fresnel(angle);
      const glm::dvec3 expected =
          left * left * glm::dvec3(0.81, 0.64, 1.0) * attenuated(0.4 / std::cos(angle), 0.7);
      // Directions need not be normalised.
      for (const float stretch : {1.0f, 3.5f}) {
        Ray ray = up_from(0.0f, angle, 100.0f * scale);
        ray.origin *= scale;
        ray.direction *= stretch;
        ray.t_far /= stretch;
        expect_share(rays.transmittance(ray), expected, 4e-3, angle);
        Blocker met;
        rays.blockers(std::span(&ray, 1), std::span(&met, 1));
        expect_share(met.transmittance, expected, 4e-3, angle);
        EXPECT_TRUE(met.see_through);
      }
    }
  }
}

TEST(Passage, ThatStartsOrEndsWithinIsAttenuatedThere) {
  World world;
  Material m = glass(1.0f, {0.25f, 0.9f, 0.5f}, 0.7f);
  m.specular = 0.0f;
  add_slab(world, 1.0f, 3.0f, m);
  const RayScene rays = rays_of(world);
  expect_share(rays.transmittance(up_from(2.5f, 0.0, 10.0f)), attenuated(0.5, 0.7), 1e-5, 1);
  expect_share(rays.transmittance(up_from(0.0f, 0.0, 2.5f)), attenuated(1.5, 0.7), 1e-5, 2);
  expect_share(rays.transmittance(up_from(0.0f, 0.0, 10.0f)), attenuated(2.0, 0.7), 1e-5, 3);
  // A ray that enters an open surface and never leaves is not attenuated.
  World open;
  add_quad(open, {-5, 1, 5}, {0, 0, -10}, {10, 0, 0}, m);
  constexpr float infinite = std::numeric_limits<float>::infinity();
  expect_share(rays_of(open).transmittance(up_from(0.0f, 0.0, infinite)), glm::dvec3(1.0), 1e-6, 4);
}

TEST(Passage, OfVolumesBehindEachOtherMultiplies) {
  World world;
  Material m = glass(1.0f, {0.25f, 0.9f, 0.5f}, 0.7f);
  m.specular = 0.0f;
  add_slab(world, 1.0f, 1.2f, m);
  m.volume.attenuation_color = {0.0f, 1.0f, 0.3f};
  add_slab(world, 2.0f, 2.1f, m);
  const glm::dvec3 expected(0.0, attenuated(0.2, 0.7).y,
                            attenuated(0.2, 0.7).z * std::pow(0.3, 0.1 / 0.7));
  expect_share(rays_of(world).transmittance(up_from(0.0f, 0.0, 10.0f)), expected, 1e-4, 0);
}

TEST(Passage, ThroughThinWallsIsTintedAndLacksWhatTheyReflect) {
  World world;
  Material m = glass(0.0f);
  m.base_color = {0.5f, 0.25f, 1.0f, 1.0f};
  m.transmission = 0.8f;
  add_quad(world, {-5, 1, 5}, {10, 0, 0}, {0, 0, -10}, m);
  for (const double angle : {0.0, 1.2}) {
    const double left = 0.8 * left_of_fresnel(angle);
    expect_share(rays_of(world).transmittance(up_from(0.0f, angle, 50.0f)),
                 left * glm::dvec3(0.5, 0.25, 1.0), 4e-3, angle);
  }
  // A coat and the metallic part reduce the transmission.
  world.materials[0].coat.factor = 1.0f;
  world.materials[0].metallic = 0.5f;
  const glm::vec3 coated = rays_of(world).transmittance(up_from(0.0f, 0.0, 50.0f));
  EXPECT_LT(coated.x, 0.5 * 0.8 * 0.96 * 0.96 * 0.5 + 1e-3);
  EXPECT_GT(coated.x, 0.0f);
}

TEST(Passage, OfCoverageHasNoColour) {
  World world;
  Material m = matte({1.0f, 0.0f, 0.5f});
  m.base_color.a = 0.25f;
  m.alpha_mode = AlphaMode::blend;
  add_quad(world, {-5, 1, 5}, {10, 0, 0}, {0, 0, -10}, m);
  EXPECT_EQ(rays_of(world).transmittance(up_from(0.0f, 0.3, 50.0f)), glm::vec3(0.75f));
}

/// Samples of the lobe under a uniform white sky.
class WhiteSky final : public LightTransport {
 public:
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {}
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics& /*counts*/) override {
    radiance += point.share * (point.material.specular + point.material.ambient);
    return true;
  }
};

// White furnace: a wall without absorption is white under a white sky, and no wall is brighter.
TEST(Passage, ThinWallsAddNoLight) {
  const Sky white(glm::vec3(1.0f));
  for (const float roughness : {0.0f, 0.4f, 1.0f}) {
    for (const float transmission : {0.3f, 1.0f}) {
      for (int kind = 0; kind < 5; ++kind) {
        World world;
        Material m = glass(0.0f);
        m.roughness = roughness;
        m.transmission = transmission;
        if (kind == 1) m.coat.factor = 1.0f;
        if (kind == 2) m.sheen.color = glm::vec3(1.0f), m.sheen.roughness = 0.5f;
        if (kind == 3) m.film.factor = 1.0f;
        if (kind == 4) m.metallic = 0.5f;
        add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, m);
        const RenderFeatures render_features = find_render_features(world);
        const RayScene rays = rays_of(world);
        const Lighting lighting;
        ShadingSettings settings{.sky_shadows = true, .sky = &white};
        for (const double angle : {0.0, 0.8, 1.3, 1.5}) {
          Ray ray{.direction = {static_cast<float>(-std::sin(angle)),
                                static_cast<float>(-std::cos(angle)), 0.0f}};
          ray.origin = -10.0f * ray.direction;
          WhiteSky transport;
          RenderStatistics counts;
          const glm::vec3 seen = Shader(world, render_features, rays, lighting, settings)
                                     .radiance(ray, rays.closest(ray), 0.0f, transport, counts);
          EXPECT_LE(seen.x, 1.0f + 1e-5f) << kind << ' ' << angle << ' ' << roughness;
          // Lobes lose multiple reflections; films have colours.
          if (kind == 0 && roughness < 0.5f) {
            EXPECT_NEAR(seen.x, 1.0, 1e-2) << angle;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::passage_test
