#include "renderer/world/framing.h"

#include "renderer/geometry/view.h"
#include "renderer/gltf/load.h"
#include "tests/support/shared_dir.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

namespace asos {
namespace {

/// The extent of the scene in a picture of this shape, as fractions of its width and height.
struct Shown {
  glm::dvec2 lo{std::numeric_limits<double>::infinity()};
  glm::dvec2 hi{-std::numeric_limits<double>::infinity()};

  Shown(const World& world, const Camera& camera, glm::ivec2 size) {
    const Frame frame = View(camera, size.x, size.y).frame(0, 0, size.x, size.y);
    const auto show = [&](glm::vec3 position) {
      const glm::dvec3 h = frame.homogeneous(glm::dvec3(position));
      EXPECT_GT(h.z, 0.0) << "behind the camera";
      const glm::dvec2 at = glm::dvec2(h) / (frame.parallel() ? 1.0 : h.z);
      lo = glm::min(lo, at);
      hi = glm::max(hi, at);
    };
    for (const glm::uvec3& triangle : world.triangles)
      for (int k = 0; k < 3; ++k) show(world.positions[triangle[k]]);
    for (const LineOrPoint& line : world.lines_and_points.segments) show(line.a), show(line.b);
    for (const LineOrPoint& point : world.lines_and_points.points) show(point.a);
  }
  [[nodiscard]] double tighter() const { return std::max(hi.x - lo.x, hi.y - lo.y); }
};

World world_of(const std::string& source) {
  const Result<Scene> scene = load_scene(source);
  EXPECT_TRUE(scene) << source;
  Result<FlattenedScene> flat = flatten(*scene);
  EXPECT_TRUE(flat) << source;
  return std::move(flat->world);
}

/// Expects a framed scene; returns the filled fraction of the tighter direction.
double expect_framed(const World& world, const Camera& camera, glm::ivec2 size,
                     const std::string& name) {
  const double aspect = static_cast<double>(size.x) / size.y;
  const FramedView framed = frame_world(world, camera, aspect);
  const Shown shown(world, framed.camera, size);
  EXPECT_GT(shown.tighter(), 0.88) << name << ", " << size.x << " x " << size.y;
  EXPECT_LT(shown.tighter(), 0.92) << name << ", " << size.x << " x " << size.y;
  // Centred in the tighter direction, and inside the picture in the other.
  const int tight = shown.hi.x - shown.lo.x > shown.hi.y - shown.lo.y ? 0 : 1;
  EXPECT_NEAR(0.5 * (shown.lo[tight] + shown.hi[tight]), 0.5, 1e-6) << name;
  EXPECT_GT(std::min(shown.lo.x, shown.lo.y), 0.0) << name;
  EXPECT_LT(std::max(shown.hi.x, shown.hi.y), 1.0) << name;
  EXPECT_GT(framed.subject_distance, 0.0) << name;
  return shown.tighter();
}

constexpr glm::ivec2 sizes[] = {{1280, 720}, {300, 900}, {500, 500}};

TEST(Framing, BuiltInScenesFillThePicture) {
  for (const char* source : {"builtin:boxes", "builtin:house-mirror"}) {
    const World world = world_of(source);
    for (const glm::ivec2 size : sizes) {
      Camera camera = default_camera(world, 1.0);
      (void)expect_framed(world, camera, size, source);
      camera.type = Camera::Type::orthographic;
      (void)expect_framed(world, camera, size, source);
    }
  }
}

// For each shared scene, if there are any, that has no camera of its own.
TEST(Framing, SharedScenesFillThePicture) {
  const auto shared = test::shared_dir();
  if (!shared) GTEST_SKIP() << "no folder of shared scenes: see ASOS_SHARED";
  const std::filesystem::path folder = *shared / "scenes";
  int framed = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".gltf" && ending != ".glb") continue;
    const Result<Scene> scene = load_scene(entry.path().string());
    if (!scene) continue;  // invalid files by design
    const Result<FlattenedScene> flat = flatten(*scene);
    if (!flat || flat->world.triangles.empty() || !flat->world.cameras.empty()) continue;
    ++framed;
    const std::string name = entry.path().string();
    const Camera camera = default_camera(flat->world, 1.0);
    std::string shares;
    for (const glm::ivec2 size : sizes)
      shares += fmt::format(" {:.3f}", expect_framed(flat->world, camera, size, name));
    std::printf("%-30s%s\n", entry.path().stem().c_str(), shares.c_str());
  }
  EXPECT_GT(framed, 10);
}

// The viewing direction stays, and units do not matter.
TEST(Framing, ScalesWithTheScene) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    World world{.positions = {glm::vec3(-size, 0, 0), glm::vec3(2 * size, 0, size),
                              glm::vec3(0, size, 0.5 * size)},
                .triangles = {{0, 1, 2}}};
    for (const glm::vec3& p : world.positions) world.bounds.grow(p);
    const Camera camera = default_camera(world, 1.5);
    (void)expect_framed(world, camera, {600, 400}, std::to_string(size));
    const FramedView framed = frame_world(world, camera, 1.5);
    EXPECT_LT(framed.subject_distance, 10.0 * size);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(framed.camera.world_from_camera[axis], camera.world_from_camera[axis]);
  }
}

// During a full turn the scene stays within the framed fraction, and reaches it.
TEST(Framing, ATurnHasTheRoomThatItNeeds) {
  for (const char* source : {"builtin:boxes", "builtin:wheel"}) {
    const World world = world_of(source);
    for (const glm::ivec2 size : sizes) {
      for (const auto type : {Camera::Type::perspective, Camera::Type::orthographic}) {
        const double aspect = static_cast<double>(size.x) / size.y;
        Camera camera = default_camera(world, 1.0);
        camera.type = type;
        const FramedView framed = frame_world(world, camera, aspect);
        camera = framed.camera;
        const glm::dvec3 back(camera.world_from_camera[2]), eye(camera.world_from_camera[3]);
        const glm::dvec3 pivot = eye - framed.subject_distance * back;
        const double room = room_to_turn(world, camera, pivot, aspect);
        double distance = 10.0 * framed.subject_distance;
        if (type == Camera::Type::perspective)
          distance = room;
        else
          camera.height = room;
        camera.world_from_camera[3] = glm::dvec4(pivot + distance * back, 1.0);
        double border = 1.0;
        constexpr int angles = 360;
        for (int i = 0; i < angles; ++i) {
          const auto turned = glm::rotate(glm::dmat4(1.0), 2.0 * std::numbers::pi * i / angles,
                                          glm::dvec3(0, 1, 0));
          Camera here = camera;
          here.world_from_camera = glm::translate(glm::dmat4(1.0), pivot) * turned *
                                   glm::translate(glm::dmat4(1.0), -pivot) *
                                   camera.world_from_camera;
          const Shown shown(world, here, size);
          border = std::min({border, shown.lo.x, shown.lo.y, 1.0 - shown.hi.x, 1.0 - shown.hi.y});
        }
        EXPECT_NEAR(border, 0.5 * (1.0 - framed_share), 4e-4) << source << ' ' << size.x;
      }
    }
  }
}

TEST(Framing, SceneWithoutExtentStaysFinite) {
  World empty, point;
  point.bounds.grow(glm::vec3(2, 3, 4));
  for (const World& world : {empty, point}) {
    for (const double aspect : {1.5, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
      const FramedView framed = frame_world(world, default_camera(world, aspect), aspect);
      EXPECT_TRUE(std::isfinite(glm::length(glm::dvec3(framed.camera.world_from_camera[3]))));
      EXPECT_GT(framed.subject_distance, 0.0);
    }
  }
}

// A line seen end on has no width that would determine a distance.
TEST(Framing, ALineSeenEndOnLiesAheadOfTheEye) {
  World world{.positions = {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 0)},
              .triangles = {{0, 1, 2}}};
  for (const glm::vec3& p : world.positions) world.bounds.grow(p);
  const FramedView framed = frame_world(world, Camera{}, 1.0);
  EXPECT_GT(framed.camera.world_from_camera[3].z, 1.0);
}

}  // namespace
}  // namespace asos
