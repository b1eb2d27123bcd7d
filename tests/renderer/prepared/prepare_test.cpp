#include "renderer/gltf/load.h"
#include "renderer/lights/studio_lighting.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shared_dir.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace asos::prepare_test {
namespace {

/// Adds an instance of a box, seen from outside or from inside.
void add_box(Scene& scene, glm::vec3 lo, glm::vec3 hi, bool inside, const Material& material) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      glm::vec3 normal(0.0f);
      normal[axis] = (side == 1) != inside ? 1.0f : -1.0f;
      for (int k = 0; k < 4; ++k) {
        glm::vec3 p = side == 1 ? hi : lo;
        p[(axis + 1) % 3] = k == 1 || k == 2 ? hi[(axis + 1) % 3] : lo[(axis + 1) % 3];
        p[(axis + 2) % 3] = k >= 2 ? hi[(axis + 2) % 3] : lo[(axis + 2) % 3];
        mesh.positions.push_back(p);
        mesh.normals.push_back(normal);
      }
      if ((side == 1) != inside) {
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
      } else {
        mesh.triangles.emplace_back(first, first + 2, first + 1);
        mesh.triangles.emplace_back(first, first + 3, first + 2);
      }
    }
  }
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(mesh);
  scene.instances.push_back(instance);
}

std::shared_ptr<const RenderScene> prepared(const Scene& scene) {
  auto result = prepare(scene);
  EXPECT_TRUE(result.has_value()) << result.error().message();
  return *result;
}

Scene lamp_over_table(float nits) {
  Scene scene;
  add_box(scene, {-2, -1, -2}, {2, 0, 2}, false, test::matte(glm::vec3(0.8f)));
  Material lamp = test::matte(glm::vec3(0.5f));
  lamp.emissive = glm::vec3(nits);
  add_box(scene, {-0.5f, 1, -0.5f}, {0.5f, 1.2f, 0.5f}, false, lamp);
  return scene;
}

TEST(Prepare, EmissiveMeshesLightAScene) {
  const auto scene = prepared(lamp_over_table(20.0f));
  EXPECT_EQ(scene->lighting->emissive_lights, 6u);
  EXPECT_EQ(scene->lights().size(), 6u);
  EXPECT_FALSE(scene->lighting->default_lights_added);
  EXPECT_TRUE(scene->render_features.rectangle_lights);
  EXPECT_FALSE(scene->render_features.punctual_lights);
  for (const Light& light : scene->lights()) EXPECT_EQ(light.own_part, 1);
}

TEST(Prepare, NegligibleEmissionGetsTheRigAsWell) {
  const auto scene = prepared(lamp_over_table(0.01f));
  EXPECT_EQ(scene->lighting->emissive_lights, 6u);
  ASSERT_EQ(scene->lights().size(), 8u);
  EXPECT_TRUE(scene->lighting->default_lights_added);
  EXPECT_EQ(scene->lights()[6].name, "Studio key");
  EXPECT_EQ(scene->lights()[6].own_part, -1);
}

TEST(Prepare, AFilesLightIsKeptAndNotDoubledByItsLamp) {
  Scene file = lamp_over_table(20.0f);
  file.instances[1].shows_light = true;
  file.lights.emplace_back();
  file.lights[0].position = {0, 0.9, 0};
  auto scene = prepared(file);
  EXPECT_EQ(scene->lighting->emissive_lights, 0u);
  EXPECT_EQ(scene->lights().size(), 1u);
  EXPECT_FALSE(scene->lighting->default_lights_added);

  file.instances[1].shows_light = false;
  scene = prepared(file);
  EXPECT_EQ(scene->lighting->emissive_lights, 6u);
  EXPECT_EQ(scene->lights().size(), 7u);

  // A light that is switched off does not count.
  file.instances[1].shows_light = true;
  file.lights[0].intensity = 0.0f;
  EXPECT_TRUE(prepared(file)->lighting->default_lights_added);
}

TEST(Prepare, TheUsersLightsGetNoDefaultLights) {
  Scene file = lamp_over_table(0.0f);
  file.added_lighting = AddedLighting::none;
  const auto dark = prepared(file);
  EXPECT_TRUE(dark->lights().empty());
  EXPECT_EQ(default_look(*dark).sky, nullptr);
  file.added_lighting = AddedLighting::environment;
  const auto lit = prepared(file);
  EXPECT_TRUE(lit->lights().empty());
  EXPECT_FALSE(lit->lighting->default_lights_added);
  EXPECT_NE(default_look(*lit).sky, nullptr);
}

TEST(Prepare, BlendedEmissionShinesByItsOpacity) {
  Scene solid = lamp_over_table(20.0f);
  Scene blended = solid;
  blended.materials[1].alpha_mode = AlphaMode::blend;
  blended.materials[1].base_color.a = 0.25f;
  Scene glass = blended;
  glass.materials[1].transmission = 0.5f;  // transmits, but its emission counts all the same
  EXPECT_FLOAT_EQ(prepared(blended)->lights()[0].intensity,
                  0.25f * prepared(solid)->lights()[0].intensity);
  EXPECT_FLOAT_EQ(prepared(glass)->lights()[0].intensity,
                  0.25f * prepared(solid)->lights()[0].intensity);
}

/// Fractions of a small picture that are brighter than a white surface in ambient light, and
/// brighter than white.
struct Brightness {
  double lit = 0.0;
  double over = 0.0;
};
Brightness brightness_of(const RenderScene& scene) {
  const RenderSettings settings = test::make_settings(48, 32, Method::uniform, 4);
  const test::Picture picture =
      test::render_picture(scene, test::first_camera(scene.world(), 1.5), settings);
  Brightness share;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const float r = picture.film.radiance[static_cast<std::size_t>(y * settings.width + x)].r;
      EXPECT_GE(r, 0.9f * ambient_radiance) << "nothing is black";
      share.lit += r > 1.2f * ambient_radiance ? 1.0 : 0.0;
      share.over += r > 1.0f ? 1.0 : 0.0;
    }
  }
  share.lit /= settings.width * settings.height;
  share.over /= settings.width * settings.height;
  return share;
}

TEST(Prepare, ARigLightsAClosedRoomFromInside) {
  for (const float scale : {0.01f, 1.0f, 1000.0f}) {
    Scene room;
    add_box(room, scale * glm::vec3(-3, 0, -2), scale * glm::vec3(3, 2.5f, 4), true,
            test::matte(glm::vec3(1)));
    // A wardrobe next to the camera, and a beam across the room.
    add_box(room, scale * glm::vec3(0.8f, 0, 1), scale * glm::vec3(2.5f, 2, 2), false,
            test::matte(glm::vec3(1)));
    add_box(room, scale * glm::vec3(-3, 2.1f, 0), scale * glm::vec3(3, 2.4f, 0.2f), false,
            test::matte(glm::vec3(1)));
    for (const glm::dvec3 target : {glm::dvec3(-1, 1, -2), glm::dvec3(2, 0.5, 1)}) {
      room.cameras = {
          test::look_at(double(scale) * glm::dvec3(-0.5, 1.6, 3.5), double(scale) * target, 1.0)};
      const auto scene = prepared(room);
      ASSERT_TRUE(scene->lighting->default_lights_added);
      const Brightness share = brightness_of(*scene);
      EXPECT_GT(share.lit, 0.6) << scale;
      EXPECT_LT(share.over, 0.1) << scale;
    }
  }
}

TEST(Prepare, AnOpenSceneAroundTheCameraHasAStudio) {
  // The camera is within the bounds, but nothing occludes the lights.
  Scene open;
  add_box(open, {-20, -1, -20}, {20, 0, 20}, false, test::matte(glm::vec3(0.8f)));
  add_box(open, {-6, 0, -6}, {-4, 12, -4}, false, test::matte(glm::vec3(0.8f)));
  open.cameras = {test::look_at({0, 2, 10}, {-2, 2, 0}, 1.0)};
  const auto scene = prepared(open);
  ASSERT_EQ(scene->lights().size(), 2u);
  const Camera& camera = scene->world().cameras.front();
  EXPECT_EQ(scene->lights()[0].position,
            studio_lighting(camera, scene->world().bounds)[0].position);
}

TEST(Prepare, SharedScenesGetTheLightsThatTheirEmittersAre) {
  const auto shared = test::shared_dir();
  if (!shared) GTEST_SKIP() << "needs ../shared";
  const auto load = [&](const char* file) {
    return prepared(load_scene((*shared / "scenes" / file).string()).value());
  };
  const auto cornell = load("CornellBoxIray/cornellBox.gltf");
  EXPECT_EQ(cornell->lighting->emissive_lights, 6u);
  EXPECT_FALSE(cornell->lighting->default_lights_added);
  const auto cubes = load("EmissiveStrengthTest/EmissiveStrengthTest.glb");
  EXPECT_EQ(cubes->lighting->emissive_lights, 30u);
  EXPECT_FALSE(cubes->lighting->default_lights_added);
  for (const auto& scene : {cornell, cubes}) {
    for (const Light& light : scene->lights()) {
      EXPECT_EQ(light.type, Light::Type::rectangle);
      EXPECT_FALSE(light.two_sided);
    }
  }
  // Two lamps in front and two red ones behind, which hardly light the scene.
  const auto car = load("ToyCar/ToyCar.gltf");
  EXPECT_TRUE(car->lighting->default_lights_added);
  EXPECT_GE(car->lighting->emissive_lights, 4u);
  EXPECT_LE(car->lighting->emissive_lights, 16u);
  const auto end =
      car->lights().begin() + static_cast<std::ptrdiff_t>(car->lighting->emissive_lights);
  for (auto light = car->lights().begin(); light != end; ++light)
    EXPECT_EQ(light->position.z < 0.0, light->color.g < 0.1f);
}

TEST(Prepare, NeonHasAboutAHundredLights) {
  const auto neon = prepare(load_scene("builtin:neon").value()).value();
  int tubes = 0, bulbs = 0, panes = 0;
  for (const Light& light : neon->lights()) {
    tubes += light.type == Light::Type::linear;
    bulbs += light.type == Light::Type::point && light.radius > 0.0;
    panes += light.type == Light::Type::rectangle;
  }
  EXPECT_GE(tubes, 50) << "one light per stroke of a letter";
  EXPECT_EQ(bulbs, 19);
  EXPECT_EQ(panes, 13);
  EXPECT_NEAR(static_cast<double>(neon->lights().size()), 100.0, 20.0);
}

}  // namespace
}  // namespace asos::prepare_test
