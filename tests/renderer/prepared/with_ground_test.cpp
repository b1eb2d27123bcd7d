#include "renderer/prepared/with_ground.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/work_counts.h"
#include "renderer/world/framing.h"
#include "renderer/world/ground.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/quad_mesh.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace asos::test::with_ground_test {
namespace {

/// A white square of 2 x 2 at height 1, optionally with lines, under a sun straight above.
Scene board(bool lines) {
  Scene scene{.source = "test"};
  add_object(scene, quad_mesh({-1, 1, 1}, {2, 0, 0}, {0, 0, -2}),
             Material{.metallic = 0.0f, .double_sided = true}, "board");
  if (lines)
    add_object(scene,
               Mesh{.positions = {{-1, 2, 0}, {1, 2, 0}}, .segments = {{0, 1}}, .material = 0},
               "line");
  scene.lights.push_back(make_sun({0, -1, 0}, std::numbers::pi_v<float>));
  return scene;
}

std::shared_ptr<const RenderScene> ready(const Scene& scene) {
  return prepare(scene).value();
}

/// Radiance of a point of the ground, in the author's coordinates, seen from below the board.
glm::vec3 ground_at(const RenderScene& scene, double x, double z) {
  Camera camera{.type = Camera::Type::orthographic,
                .world_from_camera = {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}},
                .height = 0.01};
  const glm::dvec3 eye = glm::dvec3(x, 0.99999, z) - scene.world().origin;
  camera.world_from_camera[3] = glm::dvec4(eye, 1.0);
  const RenderSettings settings = make_settings(4, 4);
  return render_picture(scene, camera, settings).film.radiance[5];
}

// The ground has half of white's albedo, so an irradiance of pi gives a radiance of 1/2. Under the
// board, which casts a shadow of its own width, no sun arrives.
TEST(WithGround, ReceivesShadows) {
  const auto scene = with_ground(ready(board(false)), Ground::on).value();
  const glm::vec3 lit = ground_at(*scene, 1.02, 0.3), dark = ground_at(*scene, 0.98, 0.3);
  EXPECT_NEAR(lit.x - dark.x, 0.38f, 1e-4f);
  EXPECT_GT(dark.x, 0.0f) << "the sky is there";
  EXPECT_EQ(ground_at(*scene, 0.0, 0.0), dark);
  EXPECT_EQ(ground_at(*scene, 1.5, -3.0), lit);
}

TEST(WithGround, LiesAtTheLowestPointAndIsSizedByTheScene) {
  const auto bare = ready(board(false));
  const auto scene = with_ground(bare, Ground::on).value();
  const Part& plate = scene->world().parts.back();
  const double radius = std::sqrt(2.0);
  const double height = static_cast<double>(plate.bounds.lo.y) + scene->world().origin.y;
  EXPECT_LT(height, 1.0);
  EXPECT_NEAR(height, 1.0, 1e-3 * radius);
  EXPECT_EQ(plate.bounds.lo.y, plate.bounds.hi.y);
  EXPECT_NEAR(plate.bounds.hi.x - plate.bounds.lo.x, 2.0 * ground_radii * radius, 1e-3);
}

// The original scene, and all that is reported about it, stays unchanged.
TEST(WithGround, DoesNotChangeTheOriginalScene) {
  const auto bare = ready(board(false));
  const auto before = bare->world().triangles.size();
  const auto scene = with_ground(bare, Ground::mirror).value();
  EXPECT_EQ(bare->world().triangles.size(), before);
  EXPECT_EQ(bare->world().parts.size(), 1u);
  EXPECT_EQ(scene->world().parts.size(), 2u);
  EXPECT_EQ(scene->world().materials.size(), scene->dfrs().size());
  EXPECT_EQ(scene->lights().size(), bare->lights().size());
  EXPECT_EQ(scene->lighting, scene->own_lighting) << "its lights were not edited";
}

TEST(WithGround, MirrorsByADfr) {
  const auto bare = ready(board(false));
  EXPECT_FALSE(bare->render_features.mirrors);
  EXPECT_FALSE(with_ground(bare, Ground::on).value()->render_features.mirrors);
  const auto scene = with_ground(bare, Ground::mirror).value();
  EXPECT_TRUE(scene->render_features.mirrors);
  ASSERT_TRUE(scene->dfrs().back());
  EXPECT_FALSE(scene->dfrs().front());
}

TEST(WithGround, EditedLightsAndRatiosStay) {
  auto edited = with_lights(ready(board(false)), {}).value();
  MaterialDfrs dfrs = edited->dfrs();
  dfrs.front().emplace();
  edited = with_dfrs(edited, dfrs).value();
  const auto scene = with_ground(edited, Ground::on).value();
  EXPECT_TRUE(scene->lights().empty());
  EXPECT_EQ(scene->own_lighting->lights.size(), 1u);
  EXPECT_EQ(scene->dfrs().front(), dfrs.front());
}

TEST(WithGround, LinesAreDrawnOnIt) {
  const Scene author = board(true);
  Camera camera;
  camera.world_from_camera[3] = {0, 0, 9, 1};
  const RenderSettings settings = make_settings(64, 36);
  const LinePicture picture = line_picture(camera, settings);
  const auto alone = with_lines(ready(author), picture).value();
  // Lines may have been drawn before or not.
  for (const auto& under : {ready(author), alone}) {
    const auto scene = with_lines(with_ground(under, Ground::on).value(), picture).value();
    const World& world = scene->world();
    EXPECT_EQ(world.lines_and_points.triangle_count,
              alone->world().lines_and_points.triangle_count);
    ASSERT_EQ(world.parts.size(), 3u);
    EXPECT_EQ(world.parts[1].name, "ground");
    EXPECT_EQ(world.parts[2].name, "line");
    ASSERT_EQ(world.triangle_part.size(), world.surface_count());
    for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
      const Part& part = world.parts[world.triangle_part[t]];
      EXPECT_GE(t, part.first_triangle);
      EXPECT_LT(t, part.first_triangle + part.triangle_count);
    }
  }
}

// The framing is the same with and without a ground.
TEST(WithGround, IsTakenAwayAgain) {
  const auto bare = ready(board(true));
  const auto on = with_ground(bare, Ground::on).value();
  EXPECT_EQ(ground_of(on->world()), Ground::on);
  EXPECT_EQ(with_ground(on, Ground::on).value(), on);
  const auto mirror = with_ground(on, Ground::mirror).value();
  EXPECT_EQ(ground_of(mirror->world()), Ground::mirror);
  EXPECT_EQ(mirror->world().triangles.size(), on->world().triangles.size());
  const auto off = with_ground(mirror, Ground::off).value();
  const World &a = off->world(), &b = bare->world();
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_part, b.triangle_part);
  EXPECT_EQ(a.materials.size(), b.materials.size());
  EXPECT_EQ(a.parts.size(), b.parts.size());
  EXPECT_EQ(a.lines_and_points.first_part, b.lines_and_points.first_part);
  EXPECT_EQ(a.lines_and_points.segments.front().part, b.lines_and_points.segments.front().part);
  EXPECT_EQ(a.bounds.lo, b.bounds.lo);
  EXPECT_EQ(a.bounds.hi, b.bounds.hi);
  EXPECT_EQ(off->dfrs().size(), bare->dfrs().size());
  const Camera camera;
  EXPECT_EQ(frame_world(on->world(), camera, 1.5).camera.world_from_camera,
            frame_world(b, camera, 1.5).camera.world_from_camera);
}

// Lines do not affect the framing either. A scene of lines only has no ground.
TEST(WithGround, LinesAreNoGroundToStandOn) {
  const LinePicture picture{Camera{}, 100, 4.0};
  const auto bare = with_lines(ready(board(true)), picture).value();
  const auto on = with_lines(with_ground(bare, Ground::on).value(), picture).value();
  const Camera camera;
  EXPECT_EQ(frame_world(on->world(), camera, 1.5).camera.world_from_camera,
            frame_world(bare->world(), camera, 1.5).camera.world_from_camera);
  Scene lines = board(true);
  lines.instances.erase(lines.instances.begin());
  const auto only = with_lines(ready(lines), picture).value();
  EXPECT_EQ(with_ground(only, Ground::on).value(), only);
}

/// The board without lights, or a closed room around the first camera.
Scene dark_scene(bool room) {
  Scene scene = board(false);
  scene.lights.clear();
  Mesh& mesh = scene.meshes[0];
  if (!room) return scene;
  mesh.positions.clear(), mesh.triangles.clear(), mesh.normals.clear();
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(4.0f * glm::vec3(glm::ivec3(i % 2, i / 2 % 2, i / 4)));
  for (const glm::uvec4 wall :
       {glm::uvec4(0, 1, 3, 2), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
        glm::uvec4(2, 3, 7, 6), glm::uvec4(0, 2, 6, 4), glm::uvec4(1, 3, 7, 5)}) {
    mesh.triangles.emplace_back(wall.x, wall.y, wall.z);
    mesh.triangles.emplace_back(wall.x, wall.z, wall.w);
  }
  Camera camera;
  camera.world_from_camera[3] = {2, 2, 3, 1};
  scene.cameras.push_back(camera);
  return scene;
}

TEST(PrepareOnGround, IsPrepareFollowedByWithGround) {
  for (const bool room : {false, true}) {
    for (const Ground ground : {Ground::on, Ground::mirror}) {
      const Scene scene = dark_scene(room);
      const auto expected = with_ground(ready(scene), ground).value();
      const std::uint64_t before = WorkDone::of(Work::geometries);
      const auto found = prepare_on_ground(scene, {}, nullptr, [&](const World&, bool dark) {
                           EXPECT_TRUE(dark);
                           return GroundChoice{ground};
                         }).value();
      EXPECT_EQ(WorkDone::of(Work::geometries), before + 1);
      EXPECT_EQ(ground_of(found->world()), ground);
      const World &a = found->world(), &b = expected->world();
      EXPECT_EQ(a.positions, b.positions);
      EXPECT_EQ(a.triangles, b.triangles);
      EXPECT_EQ(a.triangle_part, b.triangle_part);
      EXPECT_EQ(a.bounds.lo, b.bounds.lo);
      EXPECT_EQ(a.bounds.hi, b.bounds.hi);
      EXPECT_EQ(found->lights(), expected->lights());
      EXPECT_FALSE(found->lights().empty());
      EXPECT_EQ(found->dfrs(), expected->dfrs());
      EXPECT_EQ(found->render_features, expected->render_features);
      EXPECT_EQ(found->geometry->stage.floor, expected->geometry->stage.floor);
      EXPECT_EQ(found->geometry->stage.default_lighting_inside, room);
      EXPECT_EQ(expected->geometry->stage.default_lighting_inside, room);
      EXPECT_EQ(ground_at(*found, 1.5, -3.0), ground_at(*expected, 1.5, -3.0));
    }
  }
}

TEST(WithGround, EmptyScenesGetNoGround) {
  const auto bare = ready(board(false));
  EXPECT_EQ(with_ground(bare, Ground::off).value(), bare);
  Scene empty = board(false);
  empty.instances.clear();
  const auto nothing = ready(empty);
  EXPECT_TRUE(with_ground(nothing, Ground::on).value()->world().shows_nothing());
}

}  // namespace
}  // namespace asos::test::with_ground_test
