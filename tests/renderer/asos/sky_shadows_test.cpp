#include "renderer/shading/environment.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

// What a point of a matte floor gets of a sky that is the same all over, beside form factors
// (Howell, "A catalog of radiation heat transfer configuration factors").

namespace asos::test::sky_shadows_test {
namespace {

constexpr double albedo = 0.5;

Material chalk() {
  Material material = matte(glm::vec3(static_cast<float>(albedo)));
  material.specular = 0.0f;
  return material;
}

/// For a scene that is to have no other light.
Light dark() {
  Light light;
  light.type = Light::Type::directional;
  light.direction = {0, 1, 0};
  light.intensity = 1e-6f;
  return light;
}

/// A black wall that stands on the floor along z at this x, as high as given and as good as
/// infinitely long.
void add_wall(World& world, double x, double height) {
  add_quad(world, {static_cast<float>(x), 0, 1000}, {0, 0, -2000},
           {0, static_cast<float>(height), 0}, matte(glm::vec3(0.0f)));
}

void add_disk(World& world, double height, double radius) {
  constexpr int corners = 256;
  for (int i = 0; i < corners; ++i) {
    const auto at = [&](int k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      return glm::vec3(radius * std::cos(angle), height, radius * std::sin(angle));
    };
    add_triangle(world, {0, static_cast<float>(height), 0}, at(i), at(i + 1),
                 matte(glm::vec3(0.0f)));
  }
}

/// The share of the sky's light that the floor's origin gets, as a picture of a speck shows it.
double seen_share(World world, Method method, int spp, glm::dvec3 eye) {
  add_quad(world, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings;
  settings.width = settings.height = 8;
  settings.method = method;
  settings.sampling.spp = spp;
  settings.shadow.sky = true;
  settings.cull = false;
  const Film film = render_picture(*scene, look_at(eye, {0, 0, 0}, 1e-4), settings).film;
  double sum = 0.0;
  for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.r);
  return sum / static_cast<double>(film.radiance.size()) /
         (albedo * static_cast<double>(sky_radiance));
}

double wall_factor(double distance, double height) {
  return 0.5 * (1.0 - distance / std::hypot(distance, height));
}

struct Place {
  const char* name;
  World world;
  double seen;
};

std::vector<Place> places() {
  std::vector<Place> all;
  all.push_back({"open floor", {}, 1.0});
  World wall;
  add_wall(wall, 1.0, 2.0);
  all.push_back({"beside a wall", wall, 1.0 - wall_factor(1.0, 2.0)});
  World street;
  add_wall(street, 1.0, 3.0);
  add_wall(street, -2.0, 1.0);
  all.push_back({"between two walls", street, 1.0 - wall_factor(1.0, 3.0) - wall_factor(2.0, 1.0)});
  World roof;
  add_disk(roof, 1.0, 1.5);
  all.push_back({"under a disk", roof, 1.0 - 1.5 * 1.5 / (1.0 + 1.5 * 1.5)});
  return all;
}

TEST(SkyShadows, AreTheFormFactorsOfWhatHidesTheSky) {
  for (const Place& place : places()) {
    EXPECT_NEAR(seen_share(place.world, Method::asos, 1, {0, 0.4, 0.9}), place.seen, 2e-3)
        << place.name;
    EXPECT_NEAR(seen_share(place.world, Method::sobol, 1024, {0, 0.4, 0.9}), place.seen, 1e-3)
        << place.name;
  }
}

TEST(SkyShadows, AreLeftOutWhereLightsCastNone) {
  World wall;
  add_wall(wall, 1.0, 2.0);
  add_quad(wall, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk());
  const auto scene = make_render_scene(std::move(wall), {dark()});
  RenderSettings settings;
  settings.width = settings.height = 4;
  settings.shadow.sky = true;
  settings.shadow.cast = false;
  const Film film = render_picture(*scene, look_at({0, 0.4, 0.9}, {0, 0, 0}, 1e-4), settings).film;
  for (const glm::vec3& c : film.radiance)
    EXPECT_NEAR(c.r, static_cast<float>(albedo) * ambient_radiance, 1e-5f);
}

// Mirrors show surfaces with what hides the sky from them.
TEST(SkyShadows, AreSeenInMirrors) {
  World world;
  add_wall(world, 1.0, 2.0);
  Material mirror;
  mirror.roughness = 0.0f;
  add_quad(world, {-0.5f, 0.8f, 0.5f}, {1, 0, 0}, {0, 0, -1}, mirror);
  const double share = seen_share(world, Method::asos, 1, {0, 0.4, 0.3});
  const double sampled = seen_share(world, Method::sobol, 1024, {0, 0.4, 0.3});
  EXPECT_NEAR(share, sampled, 4e-3);
  EXPECT_LT(share, 1.0 - wall_factor(1.0, 2.0) - 0.1) << "the mirror hides some of it, too";
}

TEST(SkyShadows, CountTheirRays) {
  World world;
  add_wall(world, 1.0, 2.0);
  add_quad(world, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings;
  settings.width = settings.height = 8;
  const Camera camera = look_at({0, 0.4, 0.9}, {0, 0, 0}, 1e-4);
  EXPECT_EQ(render_picture(*scene, camera, settings).statistics.sky_rays, 0u);
  settings.shadow.sky = true;
  EXPECT_GE(render_picture(*scene, camera, settings).statistics.sky_rays, 64u * 8u);
}

// occlusionTexture, 1 + strength * (red - 1), is of the open sky alone: where its shadows are
// found, it would count twice.
TEST(SkyShadows, AMaterialsOcclusionStandsInForThem) {
  for (const Method method : {Method::asos, Method::sobol}) {
    for (const bool shadows : {false, true}) {
      World world;
      Material occluded = chalk();
      occluded.occlusion_texture.texture = add_texture(world,
                                                       make_image(1, 1,
                                                                  [](int, int) {
                                                                    return Texel{51, 255, 255, 255};
                                                                  }),
                                                       Wrap::repeat, Filter::linear);
      occluded.occlusion_texture.scale = 0.75f;
      add_quad(world, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, occluded);
      const auto scene = make_render_scene(std::move(world), {dark()});
      RenderSettings settings;
      settings.width = settings.height = 4;
      settings.method = method;
      settings.sampling.spp = 64;
      settings.shadow.sky = shadows;
      const double expected =
          shadows ? static_cast<double>(sky_radiance)
                  : (1.0 - 0.75 * (1.0 - 0.2)) * static_cast<double>(ambient_radiance);
      const Film film =
          render_picture(*scene, look_at({0, 0.4, 0.9}, {0, 0, 0}, 1e-4), settings).film;
      for (const glm::vec3& c : film.radiance)
        EXPECT_NEAR(static_cast<double>(c.r), albedo * expected, 1e-3 * expected);
    }
  }
}

}  // namespace
}  // namespace asos::test::sky_shadows_test
