#include "renderer/shading/shade.h"

#include "renderer/lights/studio_lighting.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/shadow_ray.h"
#include "tests/support/make_light.h"
#include "tests/support/ray_transport.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace asos {
namespace {

using test::add_quad;
using test::matte;
using test::unlit;

/// A world with its lighting, features and rays.
struct Lit {
  World world;
  Lighting lighting;
  RenderFeatures render_features;
  RayScene rays;

  explicit Lit(World w, std::vector<Light> lights = {})
      : world(std::move(w)),
        lighting(prepare_lighting(world, std::move(lights))),
        render_features(find_render_features(world).with(lighting.render_features)) {
    auto built = RayScene::build(world, alpha_at, lighting.lights);
    EXPECT_TRUE(built.has_value());
    rays = std::move(*built);
  }
  Lit(const Lit&) = delete;

  glm::vec3 look(const Ray& ray) {
    test::RayTransport transport(rays);
    return Shader(world, render_features, rays, lighting)
        .radiance(ray, rays.closest(ray), 0.0f, transport, counts);
  }
  RenderStatistics counts;
};

Ray straight_down(float x, float z) {
  return {.origin = {x, 10, z}, .direction = {0, -1, 0}};
}

World floor_world(const Material& material) {
  World world;
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, material);
  return world;
}

Light sun(glm::dvec3 direction, float lux) {
  return test::make_sun(glm::normalize(direction), lux);
}

TEST(Shader, NothingIsTheBackground) {
  Lit lit{World{}};
  EXPECT_EQ(lit.look(straight_down(0, 0)), background_radiance);
}

TEST(Shader, AmbientOfAMatteSurfaceIsItsAlbedo) {
  Lit lit{floor_world(matte({1, 0.5f, 0}))};
  const glm::vec3 c = lit.look(straight_down(0, 0));
  // The diffuse part decreases by the specular reflection, which is white and a few hundredths.
  EXPECT_NEAR(c.r, ambient_radiance, 1e-6f);
  EXPECT_NEAR(c.g, 0.5f * ambient_radiance, 0.03f * ambient_radiance);
  EXPECT_LT(c.b, 0.05f * ambient_radiance);
  EXPECT_EQ(lit.counts.shadow_rays, 0u);
}

TEST(Shader, DirectLightFollowsTheCosine) {
  Material rough = matte(glm::vec3(0.5f));
  rough.ior = 1.0f;  // reflects only at grazing angles: Lambert alone
  for (const double angle : {0.0, 0.5, 1.0}) {
    Lit lit{floor_world(rough), {sun({std::sin(angle), -std::cos(angle), 0}, 3.0f)}};
    Lit dark{floor_world(rough)};
    const float direct = lit.look(straight_down(1, 1)).r - dark.look(straight_down(1, 1)).r;
    const double expected = 0.5 * 3.0 / std::numbers::pi * std::cos(angle);
    // Schlick's term at the half angle removes (1 - cos(angle / 2))^5, less than a thousandth here.
    EXPECT_NEAR(direct, expected, 1e-3 * expected) << angle;
    EXPECT_EQ(lit.counts.shadow_rays, 1u);
  }
}

TEST(Shader, ShadowsAreHardAndBlendedSurfacesTintThem) {
  for (const float alpha : {1.0f, 0.25f}) {
    World world = floor_world(matte(glm::vec3(1)));
    Material blocker = matte(glm::vec3(1));
    blocker.base_color.a = alpha;
    if (alpha < 1.0f) blocker.alpha_mode = AlphaMode::blend;
    add_quad(world, {2, 1, 1}, {2, 0, 0}, {0, 0, -2}, blocker);
    Lit lit{std::move(world), {sun({-1, -1, 0}, 3.0f)}};
    Lit dark{floor_world(matte(glm::vec3(1)))};
    const float ambient = dark.look(straight_down(0, 0)).r;
    const float bright = lit.look(straight_down(0.99f, 0)).r - ambient;
    const float shaded = lit.look(straight_down(1.01f, 0)).r - ambient;
    EXPECT_GT(bright, 0.5f);
    EXPECT_NEAR(shaded, (1.0f - alpha) * bright, 1e-5f) << alpha;
  }
}

TEST(Shader, LightFromBehindDoesNotLeakWhateverTheNormals) {
  // Strongly tilted shading normals, towards a light behind the surface.
  World world = floor_world(matte(glm::vec3(1)));
  for (glm::vec3& n : world.normals) n = glm::normalize(glm::vec3(1, 0.2f, 0));
  const Light below = test::make_bulb({3, -0.01, 0}, 100.0f);
  Lit lit{world, {sun({-1, 0.1, 0}, 100.0f), below}};
  Lit unlit_scene{world};
  EXPECT_EQ(lit.look(straight_down(0, 0)), unlit_scene.look(straight_down(0, 0)));
  EXPECT_EQ(lit.counts.shadow_rays, 0u);
}

TEST(Shader, WindingDoesNotMatter) {
  World up = floor_world(matte(glm::vec3(0.7f)));
  World down = up;
  for (glm::uvec3& t : down.triangles) std::swap(t.y, t.z);
  World flipped = up;
  for (glm::vec3& n : flipped.normals) n = -n;
  const Light light = sun({0.2, -1, 0}, 2.0f);
  Lit a{std::move(up), {light}};
  Lit b{std::move(down), {light}};
  Lit c{std::move(flipped), {light}};
  const glm::vec3 expected = a.look(straight_down(0.5f, 0.5f));
  EXPECT_NEAR(b.look(straight_down(0.5f, 0.5f)).r, expected.r, 1e-6f);
  EXPECT_NEAR(c.look(straight_down(0.5f, 0.5f)).r, expected.r, 1e-6f);
}

TEST(Shader, NoSurfaceShadowsItself) {
  // A convex shape, lit from the viewer: any loss would be self-shadowing. At several scales and
  // far from the origin.
  for (const float radius : {1e-3f, 1.0f, 1e4f}) {
    for (const float away : {0.0f, 100.0f}) {
      World world;
      const glm::vec3 centre(away * radius, 0, -away * radius);
      test::add_sphere(world, centre, radius, 16, matte(glm::vec3(1)));
      Light light = sun({0, -1, 0}, 3.0f);
      Lit lit{world, {light}};
      light.casts_shadows = false;
      Lit unshadowed{std::move(world), {light}};
      std::mt19937 rng(5);
      std::uniform_real_distribution<float> d(-0.7f, 0.7f);
      for (int i = 0; i < 500; ++i) {
        const Ray ray{.origin = centre + radius * glm::vec3(d(rng), 5.0f, d(rng)),
                      .direction = {0, -1, 0}};
        EXPECT_EQ(lit.look(ray), unshadowed.look(ray)) << radius << " " << away << " " << i;
      }
      EXPECT_EQ(lit.counts.shadow_rays, 500u);
    }
  }
}

TEST(Shader, BlendedLayersAreCompositedInDepthOrder) {
  World world;
  add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, unlit({0, 0, 1}));
  add_quad(world, {-1, 2, 1}, {2, 0, 0}, {0, 0, -2}, unlit({1, 0, 0}, 0.25f));
  add_quad(world, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, unlit({0, 1, 0}, 0.5f));
  Lit lit{std::move(world)};
  const glm::vec3 c = lit.look(straight_down(0.3f, 0.2f));
  EXPECT_FLOAT_EQ(c.r, 0.25f);
  EXPECT_FLOAT_EQ(c.g, 0.75f * 0.5f);
  EXPECT_FLOAT_EQ(c.b, 0.75f * 0.5f);
  EXPECT_EQ(lit.counts.eye_rays, 2u);  // the rays that continued
}

/// White layers of this opacity, one behind another.
Lit stack_of(int layers, float alpha) {
  World world;
  for (int i = 0; i < layers; ++i) {
    add_quad(world, {-1, -0.01f * static_cast<float>(i), 1}, {2, 0, 0}, {0, 0, -2},
             unlit({1, 1, 1}, alpha));
  }
  return Lit{std::move(world)};
}

TEST(Shader, AStackOfLayersIsSeenThroughToItsEnd) {
  Lit lit = stack_of(200, 0.001f);
  const double left = std::pow(0.999, 200.0);
  EXPECT_NEAR(lit.look(straight_down(0.3f, 0.2f)).r,
              1.0 - left + left * static_cast<double>(sky_radiance), 1e-5);
  EXPECT_EQ(lit.counts.cut_stacks, 0u);
}

TEST(Shader, AStackOfLayersEndsWhereNothingOfTheRestIsSeen) {
  Lit lit = stack_of(500, 0.05f);
  const float seen = lit.look(straight_down(0.3f, 0.2f)).r;
  EXPECT_GT(seen, 1.0f - 1.0f / 1024.0f);
  EXPECT_LT(lit.counts.eye_rays, 140u);
  EXPECT_EQ(lit.counts.cut_stacks, 0u);
}

TEST(Shader, AStackThatIsCutIsCounted) {
  Lit lit = stack_of(1100, 0.001f);
  EXPECT_NEAR(lit.look(straight_down(0.3f, 0.2f)).r, 1.0 - std::pow(0.999, 1024.0), 1e-4);
  EXPECT_EQ(lit.counts.cut_stacks, 1u);
}

TEST(Shader, ClearLayersAreNotCounted) {
  Lit lit = stack_of(1100, 0.0f);
  EXPECT_FLOAT_EQ(lit.look(straight_down(0.3f, 0.2f)).r, sky_radiance);
  EXPECT_EQ(lit.counts.cut_stacks, 0u);
}

TEST(Shader, ThinGlassTintsWhatLiesBehind) {
  World world;
  Material glass = unlit({1, 0.5f, 0.25f});
  glass.transmission = 0.5f;
  add_quad(world, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, glass);
  Lit lit{std::move(world)};
  const glm::vec3 c = lit.look(straight_down(0.3f, 0.2f));
  EXPECT_FLOAT_EQ(c.r, 0.5f + 0.5f * sky_radiance);
  EXPECT_FLOAT_EQ(c.g, 0.25f + 0.25f * sky_radiance);
}

TEST(Shader, MaskCutsByTextureAndVertexColour) {
  World world;
  Image image{.width = 2, .height = 1, .rgba = {255, 255, 255, 0, 255, 255, 255, 255}};
  Material cut = unlit({1, 0, 0});
  cut.alpha_mode = AlphaMode::mask;
  cut.base_color_texture.texture =
      test::add_texture(world, image, Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, cut);
  EXPECT_EQ(alpha_at(world, 0, 0.2f, 0.0f), 0.0f);
  EXPECT_EQ(alpha_at(world, 0, 0.8f, 0.0f), 1.0f);
  world.colors.assign(world.positions.size(), glm::vec4(1, 1, 1, 0.6f));
  EXPECT_FLOAT_EQ(alpha_at(world, 0, 0.8f, 0.0f), 0.6f);
  Lit lit{std::move(world)};
  EXPECT_EQ(lit.look(straight_down(-0.5f, 0)), background_radiance);
  EXPECT_EQ(lit.look(straight_down(0.5f, 0)), glm::vec3(1, 0, 0));
}

TEST(Shader, NormalMapTiltsTowardsTheLight) {
  Image image;
  image.width = image.height = 1;
  image.rgba = {218, 128, 218, 255};  // tilted by 45 degrees towards +u
  const auto brightness = [&](double sun_x, bool mapped) {
    World world;
    Material m = matte(glm::vec3(1));
    const int texture = test::add_texture(world, image, Wrap::repeat, Filter::linear);
    if (mapped) m.normal_texture.texture = texture;
    // uv as in glTF: v points down in the image, so the map's up side is -v.
    add_quad(world, {-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, m);
    for (glm::vec3& n : world.normals) n = {0, 1, 0};
    Lit lit{std::move(world), {sun({-sun_x, -1, 0}, 1.0f)}};
    return lit.look(straight_down(0.3f, 0.2f)).r;
  };
  EXPECT_GT(brightness(1, true), 1.2f * brightness(1, false));
  EXPECT_LT(brightness(-1, true), 0.6f * brightness(-1, false));
}

TEST(Shader, NormalMapsGreenPointsAgainstV) {
  World world;
  Material m = matte(glm::vec3(1));
  Image image;
  image.width = image.height = 1;
  image.rgba = {128, 218, 218, 255};  // tilted towards the image's upper edge
  m.normal_texture.texture = test::add_texture(world, image, Wrap::repeat, Filter::linear);
  add_quad(world, {-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, m);  // v grows with +z
  for (glm::vec3& n : world.normals) n = {0, 1, 0};
  Hit hit{.triangle = 0};
  hit.b1 = hit.b2 = 0.3f;
  const SurfacePoint p = surface_point(world, find_render_features(world), hit, {0, 1, 0});
  EXPECT_LT(p.shading_normal.z, -0.6f);
  EXPECT_NEAR(p.shading_normal.x, 0.0f, 0.01f);
  EXPECT_GT(p.shading_normal.y, 0.6f);

  // The result is the same if only other meshes have tangents.
  world.tangents.assign(world.positions.size(), glm::vec4(0.0f));
  EXPECT_EQ(surface_point(world, find_render_features(world), hit, {0, 1, 0}).shading_normal,
            p.shading_normal);

  // The map is looked up at (v, -u): its upper edge is where u grows.
  world.materials[0].normal_texture.uv_transform = {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0),
                                                    glm::vec3(0, 0, 1)};
  const SurfacePoint turned = surface_point(world, find_render_features(world), hit, {0, 1, 0});
  EXPECT_GT(turned.shading_normal.x, 0.6f);
  EXPECT_NEAR(turned.shading_normal.z, 0.0f, 0.01f);
}

TEST(Shader, EmissionShinesByItsStrength) {
  Material m = matte(glm::vec3(0));
  m.roughness = 1.0f;
  Lit plain{floor_world(m)};
  m.emissive = {1, 0.5f, 0};
  m.emissive_strength = 4.0f;
  Lit lit{floor_world(m)};
  const glm::vec3 c = lit.look(straight_down(0, 0)) - plain.look(straight_down(0, 0));
  EXPECT_NEAR(c.r, 4.0f, 1e-5f);
  EXPECT_NEAR(c.g, 2.0f, 1e-5f);
  EXPECT_NEAR(c.b, 0.0f, 1e-6f);
}

TEST(Shader, MetalUnderTheSkyIsItsColour) {
  Material gold = matte({1.0f, 0.7f, 0.3f});
  gold.metallic = 1.0f;
  gold.roughness = 0.2f;
  Lit lit{floor_world(gold)};
  const glm::vec3 c =
      lit.look(straight_down(0, 0)) / (sky_radiance * mirrored_visibility(gold.roughness));
  EXPECT_GT(c.r, 0.85f);
  EXPECT_NEAR(c.g, 0.7f, 0.1f);
  EXPECT_NEAR(c.b, 0.3f, 0.1f);
}

TEST(Shader, ALightOnTheSurfaceGivesAFiniteResult) {
  Light light{.position = {0, 0, 0}};
  Lit lit{floor_world(matte(glm::vec3(1))), {light}};
  Hit hit{.triangle = 0, .b1 = 0.0f};
  hit.b2 = 0.5f;  // the middle of the quad's diagonal
  RenderStatistics counts;
  test::RayTransport transport(lit.rays);
  const glm::vec3 c = Shader(lit.world, lit.render_features, lit.rays, lit.lighting)
                          .radiance(straight_down(0, 0), hit, 0.0f, transport, counts);
  EXPECT_TRUE(std::isfinite(c.r + c.g + c.b));
}

TEST(SpawnOrigin, ClearsTheErrorOfThePointAndNoMore) {
  World world;
  add_quad(world, {1000, 500, -1000}, {1, 0, 0}, {0, 0, -1}, matte(glm::vec3(1)));
  const Hit hit{.triangle = 0, .b1 = 0.3f, .b2 = 0.2f};
  const SurfacePoint p = surface_point(world, RenderFeatures{}, hit, {0, 1, 0});
  const float moved = spawn_origin(p, {0, 1, 0}).y - p.position.y;
  EXPECT_GE(moved, p.error.y);
  EXPECT_LT(moved, 500.0f * 1e-5f);
  EXPECT_LT(spawn_origin(p, {0, -1, 0}).y, p.position.y);
}

// The shadow on a floor of a kilometre must not be displaced: a ray finds occluders on the line
// from the point itself, not shifted by the floor's error bound.
TEST(ShadowRay, ToASunStartsOnItsOwnLine) {
  World world;
  add_quad(world, {1000, 0, -1000}, {2000, 0, 0}, {0, 0, 2000}, matte(glm::vec3(1)));
  const Hit hit{.triangle = 0, .b1 = 0.3f, .b2 = 0.2f};
  const SurfacePoint p = surface_point(world, RenderFeatures{}, hit, {0, 1, 0});
  const float height = clear_height(p);
  EXPECT_GT(height, 1e-3f);
  for (const float side : {1.0f, -1.0f}) {
    for (const float tangent : {0.0f, 0.5f, 2.0f, 3.5f, 20.0f, 1e6f}) {
      const glm::vec3 d = glm::normalize(glm::vec3(tangent, side, 0.5f * tangent));
      const glm::vec3 way = clear_way(height, p.to_edge, glm::vec3(0, 1, 0), d);
      EXPECT_NEAR(side * way.y, height, 1e-6f * height + 1e-7f) << tangent;
      EXPECT_LE(glm::length(way), 5.0f * height) << tangent;
      if (std::abs(d.y) < 0.25f) continue;
      EXPECT_NEAR(glm::length(glm::cross(way, d)), 0.0f, 1e-5f * height) << tangent;
      const Ray ray =
          shadow_ray(p, {glm::dvec3(d), std::numeric_limits<double>::infinity(), glm::vec3(1)});
      const glm::vec3 moved = ray.origin - p.position;
      EXPECT_NEAR(glm::length(moved - way), 0.0f, 2e-4f) << tangent;
    }
  }
}

TEST(StudioLighting, WhiteComesNearWhiteAndStaysBelow) {
  const Camera camera = test::look_at({2, 1.5, 4}, {0, 0, 0}, 0.7);
  World world;
  test::add_sphere(world, {0, 0, 0}, 1.0f, 48, matte(glm::vec3(1)));
  std::vector<Light> rig = studio_lighting(camera, world.bounds);
  Lit lit{std::move(world), std::move(rig)};
  float brightest = 0.0f;
  float darkest = 1.0f;
  std::mt19937 rng(9);
  std::uniform_real_distribution<float> d(-0.6f, 0.6f);
  for (int i = 0; i < 2000; ++i) {
    Ray ray{.origin = glm::vec3(camera.world_from_camera[3])};
    ray.direction = glm::normalize(glm::vec3(d(rng), d(rng), d(rng)) - ray.origin);
    const float r = lit.look(ray).r;
    brightest = std::max(brightest, r);
    darkest = std::min(darkest, r);
  }
  EXPECT_GT(brightest, 0.8f);
  EXPECT_LT(brightest, 1.0f);
  EXPECT_GT(darkest, 0.15f);
}

}  // namespace
}  // namespace asos
