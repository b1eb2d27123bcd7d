#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/shading/sky.h"
#include "renderer/world/render_features.h"
#include "tests/support/expect_same.h"
#include "tests/support/make_settings.h"
#include "tests/support/quad_mesh.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

// Features that a scene does not need are left out; forcing them in changes no bit of any picture.

namespace asos::needs_test {
namespace {

using SharedScene = std::shared_ptr<const RenderScene>;

RenderSettings settings_of(Method method, int width, int height) {
  RenderSettings settings = test::make_settings(width, height, method, 4);
  settings.asos.max_level = 2;
  return settings;
}

constexpr std::array methods{Method::asos,          Method::asos_published, Method::uniform,
                             Method::stochastic,    Method::sobol,          Method::whitted,
                             Method::mitchell,      Method::ray_bound,      Method::average,
                             Method::sobol_adaptive};

void expect_same_pictures(const RenderScene& needed, const RenderScene& forced, int width,
                          int height) {
  const Camera camera = test::first_camera(needed.world(), static_cast<double>(width) / height);
  for (const Method method : methods) {
    SCOPED_TRACE(testing::Message() << "method " << static_cast<int>(method));
    const RenderSettings settings = settings_of(method, width, height);
    const test::Picture a = test::render_picture(needed, camera, settings);
    const test::Picture b = test::render_picture(forced, camera, settings);
    test::expect_same(a.film, b.film);
    test::expect_same(a.statistics, b.statistics);
  }
}

class ForcedBuiltin : public testing::TestWithParam<const char*> {};

TEST_P(ForcedBuiltin, GivesTheSamePictureToTheBit) {
  const Scene scene = load_scene(std::string("builtin:") + GetParam()).value();
  const SharedScene needed = prepare(scene).and_then(with_boundaries).value();
  const SharedScene forced =
      prepare(scene, RenderFeatures::all()).and_then(with_boundaries).value();
  EXPECT_GT(features_left_out(needed->render_features).size(), 5u);
  EXPECT_LE(features_left_out(forced->render_features).size(), 2u)
      << "varying opacity and sky images cannot be forced";
  EXPECT_LT(needed->geometry->memory_mb(), forced->geometry->memory_mb());
  expect_same_pictures(*needed, *forced, 24, 16);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ForcedBuiltin,
                         testing::Values("office", "primitives-ball", "primitives-linear",
                                         "primitives-rectangle", "house", "fence", "boxes",
                                         "solids"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase(name, '-');
                           return name;
                         });

void add_quad(Scene& scene, glm::vec3 corner, glm::vec3 a, glm::vec3 b, const Material& material) {
  test::add_object(scene, test::quad_mesh(corner, a, b), material);
  scene.meshes.back().texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

/// An upright pane on a floor, under an area light.
Scene pane_on_floor() {
  Scene scene;
  Material floor = test::matte({0.7f, 0.7f, 0.6f});
  floor.double_sided = true;
  add_quad(scene, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, floor);
  Material pane = test::matte({0.3f, 0.5f, 0.8f});
  pane.double_sided = true;
  pane.roughness = 0.4f;
  add_quad(scene, {-1, 0, 0.2f}, {1.9f, 0, 0.1f}, {0.1f, 1.7f, 0}, pane);
  Light light{.type = Light::Type::rectangle,
              .position = {1.0, 3.0, 2.0},
              .direction = glm::normalize(glm::dvec3(-1.0, -3.0, -2.0))};
  light.half_u = 0.4 * glm::normalize(glm::cross(light.direction, glm::dvec3(0, 1, 0)));
  light.half_v = 0.3 * glm::normalize(glm::cross(light.half_u, light.direction));
  light.intensity = 20.0f;
  scene.lights.push_back(light);
  scene.cameras.push_back(test::look_at({0.5, 1.6, 5}, {0, 0.7, 0}, 0.8));
  return scene;
}

int add_texture(Scene& scene) {
  const auto texel = [](int x, int y) {
    const auto step = static_cast<std::uint8_t>(30 * ((x + y) % 8));
    return test::Texel{static_cast<std::uint8_t>(100 + step / 2), 128,
                       static_cast<std::uint8_t>(255 - step / 4),
                       static_cast<std::uint8_t>(x < 4 ? 255 : 40)};
  };
  Texture texture{.image = static_cast<int>(scene.images.size())};
  scene.images.push_back(test::make_image(8, 8, texel));
  scene.textures.push_back(texture);
  return static_cast<int>(scene.textures.size()) - 1;
}

struct WithFeature {
  const char* name;
  bool RenderFeatures::*needed;
  std::function<void(Scene&, Material& pane)> add;
};

Light& light_of(Scene& scene, Light::Type type) {
  scene.lights[0].type = type;
  return scene.lights[0];
}

const std::vector<WithFeature>& cases() {
  using N = RenderFeatures;
  static const std::vector<WithFeature> all{
      {"texture", &N::textures,
       [](Scene& s, Material& m) { m.base_color_texture.texture = add_texture(s); }},
      {"normal_map", &N::normal_maps,
       [](Scene& s, Material& m) { m.normal_texture.texture = add_texture(s); }},
      {"unused_image", nullptr, [](Scene& s, Material&) { add_texture(s); }},
      {"vertex_colours", &N::vertex_colors,
       [](Scene& s, Material&) {
         s.meshes[1].colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 1, 0.5}, {0.3f, 0.2f, 1, 0.5f}};
       }},
      {"mask", &N::alpha_mask,
       [](Scene& s, Material& m) {
         m.base_color_texture.texture = add_texture(s);
         m.alpha_mode = AlphaMode::mask;
       }},
      {"blend", &N::alpha_blend,
       [](Scene&, Material& m) {
         m.alpha_mode = AlphaMode::blend;
         m.base_color.a = 0.3f;
       }},
      {"transmission", &N::alpha_blend, [](Scene&, Material& m) { m.transmission = 0.7f; }},
      {"varying_opacity", &N::varying_opacity,
       [](Scene& s, Material& m) {
         m.base_color_texture.texture = add_texture(s);
         m.alpha_mode = AlphaMode::blend;
       }},
      {"emission", &N::emission,
       [](Scene&, Material& m) {
         m.emissive = {0.5f, 0.4f, 0.1f};
       }},
      {"blended_emission", &N::emission,
       [](Scene&, Material& m) {
         m.emissive = {0.5f, 0.4f, 0.1f};
         m.alpha_mode = AlphaMode::blend;
         m.base_color.a = 0.7f;
       }},
      {"metal", &N::metals, [](Scene&, Material& m) { m.metallic = 0.8f; }},
      {"single_sided", &N::culling, [](Scene&, Material& m) { m.double_sided = false; }},
      {"mirror", &N::mirrors, [](Scene&, Material& m) { m.roughness = 0.1f; }},
      {"defocusing", &N::mirrors,
       [](Scene&, Material& m) {
         const DfrCurve curve{0.3, 0.9, 4.0};
         m.dfr = Dfr{{curve, curve, curve}, 0.0};
       }},
      {"shape", &N::shapes,
       [](Scene& s, Material&) {
         Instance ball{.mesh = 0, .shape = static_cast<int>(s.shapes.size())};
         ball.world_from_mesh[3] = {0.4, 0.5, 0.9, 1.0};
         s.shapes.emplace_back();
         s.instances.push_back(ball);
       }},
      {"point", &N::punctual_lights, [](Scene& s, Material&) { light_of(s, Light::Type::point); }},
      {"ball", &N::ball_lights,
       [](Scene& s, Material&) { light_of(s, Light::Type::point).radius = 0.4; }},
      {"linear", &N::linear_lights, [](Scene& s, Material&) { light_of(s, Light::Type::linear); }},
      {"disk", &N::disk_lights,
       [](Scene& s, Material&) { light_of(s, Light::Type::disk).radius = 0.4; }},
      {"sun", &N::suns,
       [](Scene& s, Material&) {
         light_of(s, Light::Type::directional).angular_diameter_rad = 0.05;
         s.lights[0].intensity = 2.0f;
       }},
      {"rectangle", &N::rectangle_lights, [](Scene&, Material&) {}},
      {"no_shadows", nullptr, [](Scene& s, Material&) { s.lights[0].casts_shadows = false; }},
      {"no_light", nullptr, [](Scene& s, Material&) { s.lights.clear(); }},
      {"crossing", &N::intersections,
       [](Scene& s, Material&) {
         add_quad(s, {0, 0.2f, -1}, {0, 0, 2}, {0.1f, 1, 0}, test::matte({0.8f, 0.2f, 0.1f}));
       }},
  };
  return all;
}

class ForcedFeature : public testing::TestWithParam<std::size_t> {};

TEST_P(ForcedFeature, ChangesNoBitWithOrWithoutTheOthers) {
  const WithFeature& with = cases()[GetParam()];
  Scene scene = pane_on_floor();
  Material pane = scene.materials[1];
  with.add(scene, pane);
  scene.materials[1] = pane;
  const SharedScene needed = prepare(scene).and_then(with_boundaries).value();
  const SharedScene forced =
      prepare(scene, RenderFeatures::all()).and_then(with_boundaries).value();
  if (with.needed) {
    EXPECT_TRUE(needed->render_features.*with.needed);
  }
  expect_same_pictures(*needed, *forced, 20, 16);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ForcedFeature, testing::Range<std::size_t>(0, 24),
                         [](const auto& index) { return std::string(cases()[index.param].name); });

/// Number of reflection rays in the picture of a scene.
std::uint64_t mirrored_rays(const RenderScene& scene, double roughest_mirror) {
  RenderSettings settings = settings_of(Method::asos, 20, 16);
  settings.mirror.roughest = roughest_mirror;
  const Camera camera = test::first_camera(scene.world(), 20.0 / 16.0);
  return test::render_picture(scene, camera, settings).statistics.reflection_rays;
}

// Rough mirrors are left out by the default limit, but are followed if the settings raise it.
TEST(ForcedNeeds, RougherMirrorsAreFollowedWhereTheSettingsAskForThem) {
  const SharedScene scene = prepare(pane_on_floor()).value();
  ASSERT_FALSE(scene->render_features.mirrors);
  EXPECT_EQ(mirrored_rays(*scene, usual_roughest_mirror), 0u);
  EXPECT_GT(mirrored_rays(*scene, 0.5), 0u);
  RenderSettings settings;
  EXPECT_FALSE(needs_of(*scene, settings).mirrors);
  settings.mirror.roughest = 0.5;
  EXPECT_TRUE(needs_of(*scene, settings).mirrors);
}

TEST(ForcedNeeds, ASkysPictureIsOfTheSettings) {
  const SharedScene scene = prepare(pane_on_floor()).value();
  RenderSettings settings{.sky = std::make_shared<const Sky>(glm::vec3(0.4f))};
  EXPECT_FALSE(needs_of(*scene, settings).sky_picture) << "a uniform colour is no image";
  settings.sky = std::make_shared<const Sky>(
      SkyMap(2, 1, std::vector{glm::vec3(0.4f), glm::vec3(0.2f)}), 0.0, "two texels");
  EXPECT_TRUE(needs_of(*scene, settings).sky_picture);
}

TEST(ForcedNeeds, TakeMemoryThatIsLeftOutOtherwise) {
  Scene scene = pane_on_floor();
  add_texture(scene);  // used by no material
  const SharedScene needed = prepare(scene).and_then(with_boundaries).value();
  EXPECT_TRUE(needed->world().colors.empty() && needed->world().tangents.empty());
  EXPECT_TRUE(needed->world().texcoords[0].empty() && needed->world().images[0].rgba.empty());
  const SharedScene forced =
      prepare(scene, RenderFeatures::all()).and_then(with_boundaries).value();
  EXPECT_EQ(forced->world().colors.size(), 8u);
  EXPECT_EQ(forced->world().tangents.size(), 8u);
  EXPECT_EQ(forced->world().texcoords[0].size(), 8u);
  EXPECT_EQ(forced->world().images[0].rgba.size(), 256u);
}

TEST(ForcedNeeds, IntersectionsAreNeededWhereSurfacesCross) {
  Scene scene = pane_on_floor();
  scene.instances[1].world_from_mesh[3].y = 0.1;  // clear of the floor
  EXPECT_FALSE(needs_of(**prepare(scene).and_then(with_boundaries), {}).intersections);
  scene.instances[1].world_from_mesh[3].y = -0.5;
  EXPECT_TRUE(needs_of(**prepare(scene).and_then(with_boundaries), {}).intersections);
}

}  // namespace
}  // namespace asos::needs_test
