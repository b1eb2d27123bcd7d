#include "app/camera_choice.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace asos {
namespace {

// A unit cube's corner triangle around the author's point (100, 0, 0).
World small_world() {
  World world;
  world.origin = {100, 0, 0};
  world.positions = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}};
  world.triangles = {{0, 1, 2}};
  for (const glm::vec3 p : world.positions) world.bounds.grow(p);
  return world;
}

TEST(CameraChoice, LookAtIsInTheAuthorsCoordinates) {
  const CameraChoice choice{{}, LookAt{{100, 0, 5}, {100, 0, 0}}, {}, 40.0};
  const auto camera = choose_camera(small_world(), choice, 1.5);
  ASSERT_TRUE(camera);
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[3]), glm::dvec3(0, 0, 5));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[0]), glm::dvec3(1, 0, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[1]), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[2]), glm::dvec3(0, 0, 1));
  EXPECT_DOUBLE_EQ(camera->fov_y_rad, 40.0 * glm::pi<double>() / 180.0);
}

TEST(CameraChoice, LookingStraightDownIsDefined) {
  const CameraChoice choice{{}, LookAt{{100, 9, 0}, {100, 0, 0}}, {}, {}};
  const auto camera = choose_camera(small_world(), choice, 1.0);
  ASSERT_TRUE(camera);
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[2]), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[1]), glm::dvec3(0, 0, -1));
  EXPECT_EQ(glm::dvec3(camera->world_from_camera[0]), glm::dvec3(1, 0, 0));
}

TEST(CameraChoice, TheFilesFirstCameraIsTheDefault) {
  World world = small_world();
  world.cameras.resize(2);
  world.cameras[0].name = "first";
  world.cameras[1].name = "second";
  EXPECT_EQ(choose_camera(world, {}, 1.0)->name, "first");
  EXPECT_EQ(choose_camera(world, {1, {}, {}, {}}, 1.0)->name, "second");
}

TEST(CameraChoice, CamerasThatAreNotThereAreRefused) {
  World world = small_world();
  EXPECT_EQ(choose_camera(world, {0, {}, {}, {}}, 1.0).error().reason, "the scene has no cameras");
  world.cameras.resize(2);
  EXPECT_EQ(choose_camera(world, {2, {}, {}, {}}, 1.0).error().reason,
            "the scene's cameras are numbered 0 to 1");
}

TEST(CameraChoice, OrthographicCamerasHaveNoFieldOfView) {
  World world = small_world();
  world.cameras.resize(1);
  world.cameras[0].type = Camera::Type::orthographic;
  EXPECT_TRUE(choose_camera(world, {}, 1.0));
  EXPECT_FALSE(choose_camera(world, {{}, {}, {}, 40.0}, 1.0));
}

}  // namespace
}  // namespace asos
