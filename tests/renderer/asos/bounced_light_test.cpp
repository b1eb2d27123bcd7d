#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

// One diffuse bounce of light between surfaces, against closed forms.

namespace asos::test::bounced_light_test {
namespace {

Material chalk(float albedo) {
  Material material = matte(glm::vec3(albedo));
  material.specular = 0.0f;
  return material;
}

/// The walls of a cube from -1 to 1, facing inwards.
void add_room(World& world, const Material& material) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 corner(-1.0f), a(0.0f), b(0.0f);
      corner[axis] = sign;
      a[(axis + 1) % 3] = b[(axis + 2) % 3] = 2.0f;
      if (sign > 0.0f) std::swap(a, b);
      add_quad(world, corner, a, b, material);
    }
  }
}

/// Each wall of the room as a light of 1 cd/m².
std::vector<Light> shining_walls() {
  std::vector<Light> lights;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      constexpr double inset = 1.0 - 1e-5;
      Light light{.type = Light::Type::rectangle, .intensity = 1.0f};
      light.position[axis] = inset * sign;
      light.direction = glm::dvec3(0.0);
      light.direction[axis] = -sign;
      light.half_u[(axis + 1) % 3] = light.half_v[(axis + 2) % 3] = 1.0;
      lights.push_back(light);
    }
  }
  return lights;
}

/// Mean brightness of a small picture towards (0, -1, 0.1).
double brightness(const RenderScene& scene, Method method, int bounces, glm::dvec3 eye = {0, 0, 0},
                  float sky = 0.0f) {
  RenderSettings settings = make_settings(24, 24, method, 512);
  settings.shadow.bounces = bounces;
  settings.cull = false;
  settings.sky = std::make_shared<const Sky>(glm::vec3(sky));
  const Film film = render_picture(scene, look_at(eye, {0, -1, 0.1}, 0.1), settings).film;
  double sum = 0.0;
  for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.g);
  return sum / static_cast<double>(film.radiance.size());
}

// White furnace: all walls emit a radiance of 1, so a wall reflects its albedo, and with one bounce
// also its albedo times what the other walls reflect.
TEST(BouncedLight, WhiteFurnaceMatchesTheGeometricSeries) {
  for (const float albedo : {0.5f, 0.8f}) {
    World world;
    add_room(world, chalk(albedo));
    const auto scene = make_render_scene(std::move(world), shining_walls());
    const double direct = static_cast<double>(albedo);
    for (const Method method : {Method::asos, Method::sobol}) {
      EXPECT_NEAR(brightness(*scene, method, 0), direct, 1e-3 * direct);
      const double all = direct * (1.0 + direct);
      EXPECT_NEAR(brightness(*scene, method, 1), all, 1e-3 * all) << static_cast<int>(method);
    }
  }
}

// Unlit surfaces are light sources, too.
TEST(BouncedLight, UnlitWallsShineOnWhatTheyEnclose) {
  World world;
  Material unlit = matte(glm::vec3(0.6f));
  unlit.unlit = true;
  add_room(world, unlit);
  add_quad(world, {-0.2f, -0.5f, 0.2f}, {0.4f, 0, 0}, {0, 0, -0.4f}, chalk(0.5f));
  Light dark{.intensity = 1e-9f};
  const auto scene = make_render_scene(std::move(world), {dark});
  for (const Method method : {Method::asos, Method::sobol})
    EXPECT_NEAR(brightness(*scene, method, 1), 0.5 * 0.6, 1e-3);
}

// A small floor at an endless wall, in uniform surroundings. The wall sees only the
// surroundings; the floor's point sees the wall with its form factor.
TEST(BouncedLight, SkyLitWallLightsTheFloor) {
  constexpr double albedo = 0.5, height = 2.0;
  World world;
  add_quad(world, {0.5f, 0, 1000}, {0, 0, -2000}, {0, static_cast<float>(height), 0},
           chalk(static_cast<float>(albedo)));
  add_quad(world, {-0.1f, 0, 0.1f}, {0.2f, 0, 0}, {0, 0, -0.2f}, chalk(static_cast<float>(albedo)));
  Light dark{.intensity = 1e-9f};
  const auto scene = make_render_scene(std::move(world), {dark});
  const double hidden = 0.5 * (1.0 - 0.5 / std::hypot(0.5, height));
  // Below the horizon there is only sky, of the same radiance: it lights the wall's face half from
  // above and half from below.
  const double expected = albedo * ((1.0 - hidden) + hidden * albedo);
  for (const Method method : {Method::asos, Method::sobol})
    EXPECT_NEAR(brightness(*scene, method, 1, {0, 1, -0.1}, 1.0f), expected, 4e-3 * expected);
}

TEST(BouncedLight, IsLeftOutWhereLightsCastNoShadows) {
  World world;
  add_room(world, chalk(0.5f));
  const auto scene = make_render_scene(std::move(world), shining_walls());
  RenderSettings settings = make_settings(4, 4);
  settings.shadow.cast = false;
  const Camera camera = look_at({0, 0, 0}, {0, -1, 0.1}, 0.1);
  const auto without = render_picture(*scene, camera, settings).film.radiance;
  settings.shadow.bounces = 1;
  EXPECT_EQ(render_picture(*scene, camera, settings).film.radiance, without);
}

}  // namespace
}  // namespace asos::test::bounced_light_test
