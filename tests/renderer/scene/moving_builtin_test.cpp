#include "renderer/gltf/load.h"
#include "renderer/scene/posable_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos {
namespace {

Scene moving(const std::string& name) {
  Result<Scene> scene = load_scene("builtin:" + name, {.keep_posable = true});
  EXPECT_TRUE(scene) << scene.error().message();
  return *std::move(scene);
}

glm::dvec3 moved(const Scene& scene, glm::dvec3 p) {
  return glm::dvec3(scene.instances.back().world_from_mesh * glm::dvec4(p, 1.0));
}

TEST(MovingBuiltins, KeepTheirRigOnlyWhereItIsAskedFor) {
  for (const char* name : {"turning-fence", "walking-pole"}) {
    EXPECT_TRUE(moving(name).rig);
    EXPECT_FALSE(load_scene(std::string("builtin:") + name)->rig);
    ASSERT_EQ(moving(name).contents.animations.size(), 1u);
    EXPECT_FALSE(moving(name).notes.not_shown.empty()) << "that it moves";
  }
}

TEST(MovingBuiltins, AreAtRestAsAtTheirBeginning) {
  for (const char* name : {"turning-fence", "walking-pole"}) {
    const Scene rest = moving(name);
    const Result<Scene> start = rest.rig->pose(ClipTime{0, 0.0});
    ASSERT_TRUE(start);
    EXPECT_EQ(start->time, (ClipTime{0, 0.0}));
    EXPECT_EQ(start->instances.back().world_from_mesh, rest.instances.back().world_from_mesh);
  }
}

TEST(MovingBuiltins, TheFenceTurnsEvenlyOnce) {
  const Scene rest = moving("turning-fence");
  const glm::dvec3 end(0.9, 0.5, 0.0);
  for (const double seconds : {0.0, 2.5, 7.5, 15.0, 30.0, 31.0}) {
    const double angle = 2.0 * std::numbers::pi * std::min(seconds, 30.0) / 30.0;
    const glm::dvec3 at = moved(*rest.rig->pose(ClipTime{0, seconds}), end);
    EXPECT_NEAR(at.x, 0.9 * std::cos(angle), 1e-12) << seconds;
    EXPECT_NEAR(at.z, -0.9 * std::sin(angle), 1e-12) << seconds;
    EXPECT_EQ(at.y, 0.5);
  }
}

TEST(MovingBuiltins, ThePoleWalksByAQuarterOfAPixel) {
  const Scene rest = moving("walking-pole");
  const glm::dvec3 step = moved(*rest.rig->pose(ClipTime{0, 1.0 / 24.0}), {}) - moved(rest, {});
  const Camera& camera = rest.cameras.front();
  const double distance = camera.world_from_camera[3].z;
  const double pixel = 2.0 * distance * std::tan(0.5 * camera.fov_y_rad) / 180.0;
  EXPECT_GT(step.x, 0.2 * pixel);
  EXPECT_LT(step.x, 0.3 * pixel);
  EXPECT_EQ(step.y, 0.0);
  EXPECT_EQ(step.z, 0.0);
}

TEST(MovingBuiltins, RefuseOtherAnimationsAndTimes) {
  const Scene rest = moving("walking-pole");
  for (const ClipTime time :
       {ClipTime{1, 0.0}, ClipTime{-1, 0.0}, ClipTime{0, -1.0}, ClipTime{0, std::nan("")}}) {
    const Result<Scene> none = rest.rig->pose(time);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message().rfind("builtin:walking-pole: ", 0), 0u);
  }
}

}  // namespace
}  // namespace asos
