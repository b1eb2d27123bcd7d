#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

// Light of a uniform sky on a point of a matte floor, against form factors (Howell, "A catalog of
// radiation heat transfer configuration factors").

namespace asos::test::sky_shadows_test {
namespace {

constexpr double albedo = 0.5;

Material chalk() {
  Material material = matte(glm::vec3(static_cast<float>(albedo)));
  material.specular = 0.0f;
  return material;
}

/// A light that suppresses the default lighting.
Light dark() {
  return make_sun({0, 1, 0}, 1e-6f);
}

/// A black wall on the floor along z at this x, of this height and practically infinite length.
void add_wall(World& world, double x, double height) {
  add_quad(world, {static_cast<float>(x), 0, 1000}, {0, 0, -2000},
           {0, static_cast<float>(height), 0}, matte(glm::vec3(0.0f)));
}

/// A wall of height 2 at x = 1 and one at z = -2, each 3 long from their common corner.
void add_corner(World& world) {
  add_quad(world, {1, 0, 1}, {0, 0, -3}, {0, 2, 0}, matte(glm::vec3(0.0f)));
  add_quad(world, {-2, 0, -2}, {3, 0, 0}, {0, 2, 0}, matte(glm::vec3(0.0f)));
}

void add_disk(World& world, double height, double radius) {
  constexpr int corners = 1024;
  for (int i = 0; i < corners; ++i) {
    const auto at = [&](int k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      return glm::vec3(radius * std::cos(angle), height, radius * std::sin(angle));
    };
    add_triangle(world, {0, static_cast<float>(height), 0}, at(i), at(i + 1),
                 matte(glm::vec3(0.0f)));
  }
}

/// How to measure the fraction of the sky's light that the floor's origin receives.
struct Asked {
  Method method = Method::asos;
  int spp = 1;
  glm::dvec3 eye{0, 0.4, 0.9};
  int seeds = 1;
  bool exact = false;  ///< EPS 0, and a white sky
};

/// Measures the fraction with pictures of a tiny area.
double seen_share(World world, const Asked& asked) {
  // A small floor, because rays start higher above large triangles.
  add_quad(world, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings = make_settings(8, 8, asked.method, asked.spp);
  settings.shadow.sky = true;
  settings.cull = false;
  double radiance = static_cast<double>(sky_radiance);
  if (asked.exact) {
    radiance = 1.0 / albedo;
    settings.sky = std::make_shared<const Sky>(glm::vec3(static_cast<float>(radiance)));
    settings.asos.max_level = 6;
    settings.asos.eps = 0.0;
  }
  double sum = 0.0;
  for (settings.seed = 0; settings.seed < asked.seeds; ++settings.seed) {
    const Film film = render_picture(*scene, look_at(asked.eye, {0, 0, 0}, 1e-4), settings).film;
    for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.r);
  }
  return sum / (64.0 * asked.seeds * albedo * radiance);
}

double wall_factor(double distance, double height) {
  return 0.5 * (1.0 - distance / std::hypot(distance, height));
}

/// Howell's B-4: the form factor of a wall of finite height and length, seen from a floor point in
/// front of its end.
double end_factor(double distance, double height, double length) {
  const double x = height / length, y = distance / length, r = std::hypot(x, y);
  return (std::atan(1.0 / y) - y / r * std::atan(1.0 / r)) / (2.0 * std::numbers::pi);
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
  World corner;
  add_corner(corner);
  all.push_back({"in a corner", corner,
                 1.0 - end_factor(1.0, 2.0, 1.0) - end_factor(1.0, 2.0, 2.0) -
                     end_factor(2.0, 2.0, 1.0) - end_factor(2.0, 2.0, 2.0)});
  World roof;
  add_disk(roof, 1.0, 1.5);
  all.push_back({"under a disk", roof, 1.0 - 1.5 * 1.5 / (1.0 + 1.5 * 1.5)});
  return all;
}

// All pixels of these pictures share results, so a picture has the noise of a single pixel.
TEST(SkyShadows, MatchFormFactorsOfOccluders) {
  for (const Place& place : places()) {
    EXPECT_NEAR(seen_share(place.world, {.seeds = 64}), place.seen, 2e-3) << place.name;
    EXPECT_NEAR(seen_share(place.world, {.method = Method::sobol, .spp = 1024}), place.seen, 1e-3)
        << place.name;
  }
}

// At EPS 0, the mean over seeds is within 1e-4 of the catalogue.
TEST(SkyShadows, AreExactAtEpsZero) {
  for (const Place& place : places())
    EXPECT_NEAR(seen_share(place.world, {.seeds = 16, .exact = true}), place.seen, 1e-4)
        << place.name;
}

/// A picture of a floor with the objects of `world`, lit only by the sky.
Picture floor_picture(World world, Method method, int size, int max_level = 3) {
  add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings = make_settings(size, size, method, 1024);
  settings.asos.max_level = max_level;
  settings.shadow.sky = true;
  return render_picture(*scene, look_at({0, 4, 4}, {0, 0, 0}, 0.7), settings);
}

/// Five black squares in a row at this height above the floor.
World specks(float height) {
  World world;
  for (int i = 0; i < 5; ++i)
    add_quad(world, {-1.0f + 0.47f * static_cast<float>(i), height, 0.3f}, {0.25f, 0, 0},
             {0, 0, -0.25f}, matte(glm::vec3(0.0f)));
  return world;
}

double root_mean_square(const Film& found, const Film& exact) {
  double square = 0.0;
  for (std::size_t i = 0; i < exact.radiance.size(); ++i) {
    const double off = static_cast<double>(found.radiance[i].x - exact.radiance[i].x);
    square += off * off / static_cast<double>(exact.radiance.size());
  }
  return std::sqrt(square);
}

// Leaves of one surface share results: with fewer rays than independent leaves would need, the
// noise is small.
TEST(SkyShadows, AreSharedOverASurface) {
  World wall;
  add_wall(wall, 2.0, 1.0);
  constexpr int size = 32;
  const Picture shared = floor_picture(wall, Method::asos, size);
  EXPECT_LT(root_mean_square(shared.film, floor_picture(wall, Method::sobol, size).film), 1.5e-3);
  EXPECT_LT(shared.statistics.sky_rays, 90u * size * size);
}

// Matte ground under an open sky needs no more than the first round of rays, whatever the sky's
// pattern.
TEST(SkyShadows, OpenGroundUnderAPictureHasNoNoise) {
  World world;
  add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings;
  settings.width = settings.height = 16;
  settings.shadow.sky = true;
  settings.sky = std::make_shared<const Sky>(Environment::softboxes);
  const Picture found = render_picture(*scene, look_at({0, 4, 4}, {0, 0, 0}, 0.7), settings);
  for (const glm::vec3& c : found.film.radiance)
    EXPECT_NEAR(c.g, found.film.radiance.front().g, 1e-3f);
  EXPECT_LE(found.statistics.sky_rays, 64u * 16u * 16u);
}

// EPS sets the accuracy where MAX allows enough rays.
TEST(SkyShadows, AreWithinEpsWhereMaxAllowsIt) {
  const World world = specks(0.2f);
  constexpr int size = 32;
  const Film exact = floor_picture(world, Method::sobol, size).film;
  for (const int max_level : {3, 4, 5})
    EXPECT_LT(root_mean_square(floor_picture(world, Method::asos, size, max_level).film, exact),
              2.5e-3)
        << max_level;
}

// A wall shades mostly a narrow strip of the adjacent pixel. The result is the mean over the pixel,
// not the value at its centre.
TEST(SkyShadows, AreTheMeanOverAPixelThatAWallBorders) {
  constexpr double height = 0.02, side = 0.2;
  constexpr int size = 4;
  World wall;
  add_wall(wall, 1.0, height);
  add_quad(wall, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, chalk());
  const auto scene = make_render_scene(std::move(wall), {dark()});
  // The last column of pixels ends at the wall.
  Camera camera = look_at({1.0 - size * side / 2.0, 5, 0.01}, {1.0 - size * side / 2.0, 0, 0}, 0.7);
  camera.type = Camera::Type::orthographic;
  camera.height = size * side;
  RenderSettings settings = make_settings(size, size);
  settings.shadow.sky = true;
  constexpr int seeds = 64;
  double seen = 0.0;
  for (settings.seed = 0; settings.seed < seeds; ++settings.seed) {
    const Film film = render_picture(*scene, camera, settings).film;
    for (int y = 0; y < size; ++y)
      seen += static_cast<double>(film.radiance[film.index(size - 1, y)].r) /
              (albedo * static_cast<double>(sky_radiance) * size * seeds);
  }
  // If the first few rays all reach the sky, more are rarely sent: this adds 3e-3.
  EXPECT_NEAR(seen, 0.5 * (1.0 + (std::hypot(side, height) - height) / side), 6e-3);
  EXPECT_LT(seen, 1.0 - wall_factor(side / 2.0, height) - 0.03)
      << "the value at the pixel's centre";
}

// A dark shadow between the nodes, narrower than a pixel, is found by the leaves inside it.
TEST(SkyShadows, SmallShadowsSurviveSharing) {
  const World world = specks(0.02f);
  constexpr int size = 64;
  const Film found = floor_picture(world, Method::asos, size).film;
  const Film exact = floor_picture(world, Method::sobol, size).film;
  for (std::size_t i = 0; i < exact.radiance.size(); ++i)
    EXPECT_NEAR(found.radiance[i].x, exact.radiance[i].x, 0.02f) << i % size << ' ' << i / size;
}

// On glossy surfaces each ray sees another part of a gradient. The reflection is as accurate as EPS
// requires even if a few rays prove that nothing is hidden.
TEST(SkyShadows, GlossyReflectionOfAGradientIsWithinEps) {
  for (const float metallic : {0.0f, 1.0f}) {
    World world;
    Material material = matte(glm::vec3(0.8f));
    material.metallic = metallic;
    material.specular = 1.0f;
    material.roughness = 0.5f;
    add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, material);
    const auto scene = make_render_scene(std::move(world), {dark()});
    RenderSettings settings = make_settings(16, 16);
    settings.shadow.sky = true;
    settings.sky = std::make_shared<const Sky>(Environment::studio);
    settings.sampling.spp = 4096;
    const Camera camera = look_at({0, 2, 4}, {0, 0, 0}, 0.7);
    const Film found = render_picture(*scene, camera, settings).film;
    settings.method = Method::sobol;
    const Film exact = render_picture(*scene, camera, settings).film;
    EXPECT_LT(root_mean_square(found, exact), 0.5 * settings.asos.eps) << metallic;
  }
}

TEST(SkyShadows, AreLeftOutWhereLightsCastNone) {
  World wall;
  add_wall(wall, 1.0, 2.0);
  add_quad(wall, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk());
  const auto scene = make_render_scene(std::move(wall), {dark()});
  RenderSettings settings = make_settings(4, 4);
  settings.shadow.sky = true;
  settings.shadow.cast = false;
  const Film film = render_picture(*scene, look_at({0, 0.4, 0.9}, {0, 0, 0}, 1e-4), settings).film;
  for (const glm::vec3& c : film.radiance)
    EXPECT_NEAR(c.r, static_cast<float>(albedo) * ambient_radiance, 1e-5f);
}

// Surfaces in mirrors have sky shadows, too.
TEST(SkyShadows, AreSeenInMirrors) {
  World world;
  add_wall(world, 1.0, 2.0);
  Material mirror;
  mirror.roughness = 0.0f;
  add_quad(world, {-0.5f, 0.8f, 0.5f}, {1, 0, 0}, {0, 0, -1}, mirror);
  const double share = seen_share(world, {.eye = {0, 0.4, 0.3}});
  const double sampled =
      seen_share(world, {.method = Method::sobol, .spp = 1024, .eye = {0, 0.4, 0.3}});
  EXPECT_NEAR(share, sampled, 4e-3);
  EXPECT_LT(share, 1.0 - wall_factor(1.0, 2.0) - 0.1) << "the mirror also occludes the sky";
}

TEST(SkyShadows, CountTheirRays) {
  World world;
  add_wall(world, 1.0, 2.0);
  add_quad(world, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk());
  const auto scene = make_render_scene(std::move(world), {dark()});
  RenderSettings settings = make_settings(8, 8);
  const Camera camera = look_at({0, 0.4, 0.9}, {0, 0, 0}, 1e-4);
  EXPECT_EQ(render_picture(*scene, camera, settings).statistics.sky_rays, 0u);
  settings.shadow.sky = true;
  EXPECT_GE(render_picture(*scene, camera, settings).statistics.sky_rays, 64u * 8u);
}

// occlusionTexture, 1 + strength * (red - 1), applies only without sky shadows; otherwise occlusion
// would count twice.
TEST(SkyShadows, ReplaceTheMaterialsOcclusion) {
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
      RenderSettings settings = make_settings(4, 4, method, 64);
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
