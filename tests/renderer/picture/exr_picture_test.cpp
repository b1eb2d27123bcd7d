#include "renderer/picture/exr_picture.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/with_ground.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
namespace {

// A point of the scene is where the picture shows it, as OpenEXR's matrices say.
TEST(ExrPicture, MatricesProjectPointsToTheirPixels) {
  FlattenedScene still = test::still_life();
  still.world.origin = {10.0, 20.0, 30.0};
  const auto scene = test::make_render_scene(std::move(still));
  Camera perspective = test::look_at({1, 2, 5}, {0, 0.6, 0}, 0.7);
  Camera parallel = perspective;
  parallel.type = Camera::Type::orthographic;
  parallel.height = 4.0;
  RenderSettings settings = test::make_settings(64, 40);
  for (const Camera& camera : {perspective, parallel})
    for (const PixelRect crop : {PixelRect{}, PixelRect{16, 8, 32, 16}}) {
      settings.crop = crop;
      const ExrOptions options = exr_options(*scene, camera, settings);
      const View view(camera, settings.width, settings.height);
      const Ray ray = view.ray(40.25, 12.5);
      const float t = 3.0f;
      const glm::dvec3 point = scene->world().origin + glm::dvec3(ray.origin) +
                               static_cast<double>(t) * glm::dvec3(ray.direction);
      const glm::dvec4 seen = *options.world_to_camera * glm::dvec4(point, 1.0);
      EXPECT_NEAR(seen.z, view.depth(ray, t), 1e-5) << "+z is ahead";
      const glm::dvec4 ndc = *options.world_to_ndc * glm::dvec4(point, 1.0);
      EXPECT_NEAR(ndc.x / ndc.w, 40.25 / 64.0, 1e-5);
      EXPECT_NEAR(ndc.y / ndc.w, 12.5 / 40.0, 1e-5);
      ASSERT_TRUE(options.window);
      EXPECT_EQ(options.window->width, 64);
      EXPECT_EQ(options.window->x, crop.x);
      EXPECT_EQ(options.window->y, crop.y);
    }
}

TEST(ExrPicture, NamesComeWithIds) {
  const auto scene = test::make_render_scene(test::still_life());
  RenderSettings settings;
  EXPECT_TRUE(exr_options(*scene, {}, settings).object_names.empty());
  settings.layers = {Layer::object};
  const ExrOptions options = exr_options(*scene, {}, settings);
  EXPECT_EQ(options.object_names.size(), scene->world().parts.size());
  EXPECT_EQ(options.layers, settings.layers);
}

// An object's asset is the node at the top of its tree. Lines belong to nodes, too; the ground and
// objects without nodes do not.
TEST(ExrPicture, AssetsAreTopLevelNodes) {
  Scene file = load_scene("builtin:boxes").value();
  file.contents.nodes = {{"house", -1}, {"door", 0}, {"handle", 1}, {"", -1}};
  ASSERT_GE(file.instances.size(), 4u);
  file.instances[0].node = 2;
  file.instances[1].node = 0;
  file.instances[2].node = 3;
  Instance fence = file.instances[0];
  fence.shape = -1;
  fence.mesh = static_cast<int>(file.meshes.size());
  fence.name = "fence";
  fence.node = 1;
  Mesh lines{.positions = {{0, 0, 0}, {0, 1, 0}}, .segments = {{0, 1}}};
  file.meshes.push_back(lines);
  file.instances.insert(file.instances.begin(), fence);
  const auto scene = with_ground(prepare(file).value(), Ground::on).value();
  RenderSettings settings{.layers = {Layer::object}};
  const ExrOptions options = exr_options(*scene, {}, settings);
  ASSERT_EQ(options.asset_names.size(), scene->world().parts.size());
  EXPECT_EQ(options.asset_names[0], "house");
  EXPECT_EQ(options.asset_names[1], "house");
  EXPECT_EQ(options.asset_names[2], "node 4");
  EXPECT_EQ(options.asset_names[3], options.object_names[3]) << "in no node";
  ASSERT_EQ(options.object_names.back(), "fence");
  EXPECT_EQ(options.asset_names.back(), "house");
  EXPECT_EQ(options.asset_names[scene->world().solid_parts() - 1], "ground");
}

}  // namespace
}  // namespace asos
