#include "renderer/prepared/without_objects.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/prepared/with_lines.h"
#include "renderer/work_counts.h"
#include "renderer/world/ground.h"
#include "tests/renderer/prepared/line_scenes.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

// Scenes without some of their objects: the pictures of a scene that was prepared without them, and
// nothing is built again.

namespace asos::test::without_objects_test {
namespace {

std::shared_ptr<const RenderScene> ready(const Scene& scene,
                                         const AnimationInvariants* stage = nullptr) {
  return prepare(scene, {}, stage).value();
}

/// Every `nth` object.
std::vector<std::uint8_t> every(std::size_t nth, const World& world) {
  std::vector<std::uint8_t> hidden(objects_without_ground(world), 0);
  for (std::size_t i = 1; i < hidden.size(); i += nth) hidden[i] = 1;
  return hidden;
}

/// Removes the same objects from a scene.
Scene removed(Scene scene, const std::vector<std::uint8_t>& hidden) {
  std::size_t object = 0;
  std::erase_if(scene.instances, [&](const Instance& instance) {
    return scene.shows_surface(instance) && hidden[object++] != 0;
  });
  return scene;
}

std::vector<glm::vec3> picture(const RenderScene& scene, const Camera& camera, Method method) {
  const RenderSettings settings = make_settings(48, 27, method, 4);
  return render_picture(scene, camera, settings).film.radiance;
}

struct Counts {
  std::uint64_t surfaces = WorkDone::of(Work::hierarchy_surfaces);
  std::uint64_t pairs = WorkDone::of(Work::coplanar_pairs);
  std::uint64_t files = WorkDone::of(Work::files_read);
  std::uint64_t lookups = WorkDone::of(Work::emission_lookups);
  bool operator==(const Counts&) const = default;
};

class WithoutObjects : public ::testing::TestWithParam<const char*> {};

TEST_P(WithoutObjects, ShowsThePictureOfASceneThatNeverHadThem) {
  const Scene scene = load_scene(std::string("builtin:") + GetParam()).value();
  const auto whole = ready(scene);
  const Camera camera = first_camera(whole->world(), 16.0 / 9.0);
  for (const std::size_t nth : {2u, 3u}) {
    const std::vector<std::uint8_t> hidden = every(nth, whole->world());
    const Counts before;
    const auto left = without_objects(whole, hidden, nullptr).value();
    Counts after;
    const std::uint64_t pairs = after.pairs - before.pairs;
    after.pairs = before.pairs;
    EXPECT_EQ(after, before);
    const auto alone = ready(removed(scene, hidden), &whole->geometry->stage);
    EXPECT_LE(pairs, Counts().pairs - before.pairs - pairs)
        << "only triangles whose known partner is hidden are compared again";
    const World &a = left->world(), &b = alone->world();
    ASSERT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.triangle_part, b.triangle_part);
    EXPECT_EQ(a.bounds.lo, b.bounds.lo);
    EXPECT_EQ(a.bounds.hi, b.bounds.hi);
    EXPECT_EQ(left->lights(), alone->lights());
    for (const Method method : {Method::sobol, Method::asos})
      EXPECT_EQ(picture(*left, camera, method), picture(*alone, camera, method)) << nth;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, WithoutObjects,
                         ::testing::Values("office", "house-textured", "glass", "fence", "mixed"));

TEST(WithoutObjects, TakesTheirLightAway) {
  const Scene scene = load_scene("builtin:neon").value();
  const auto whole = ready(scene);
  const auto owned = [](const Light& light) { return light.own_part >= 0; };
  const auto lamp = std::find_if(whole->lights().begin(), whole->lights().end(), owned);
  ASSERT_NE(lamp, whole->lights().end());
  std::vector<std::uint8_t> hidden(objects_without_ground(whole->world()), 0);
  hidden[static_cast<std::size_t>(lamp->own_part)] = 1;
  hidden[0] = 1;
  const auto left = without_objects(whole, hidden, nullptr).value();
  std::size_t expected = 0;
  for (const Light& light : whole->lights()) {
    if (owned(light) && hidden[static_cast<std::size_t>(light.own_part)]) continue;
    const Light& found = left->lights().at(expected++);
    EXPECT_EQ(found.name, light.name);
    if (!owned(light)) continue;
    EXPECT_EQ(left->world().parts.at(static_cast<std::size_t>(found.own_part)).name,
              whole->world().parts.at(static_cast<std::size_t>(light.own_part)).name);
  }
  EXPECT_EQ(left->lights().size(), expected);
  EXPECT_LT(expected, whole->lights().size());
}

// The ground under a part of a model would be smaller, and the model would seem to move.
TEST(WithoutObjects, LeaveTheGroundWhereItIs) {
  const auto bare = ready(load_scene("builtin:office").value());
  const auto whole = with_ground(bare, Ground::on).value();
  const std::vector<std::uint8_t> hidden = every(2, whole->world());
  const auto place = [](const RenderScene& scene) {
    const World& world = scene.world();
    return world.parts.at(world.solid_parts() - 1).bounds;
  };
  const auto left = without_objects(whole, hidden, nullptr).value();
  ASSERT_EQ(ground_of(left->world()), Ground::on);
  EXPECT_EQ(place(*left).lo, place(*whole).lo);
  EXPECT_EQ(place(*left).hi, place(*whole).hi);
  const auto again = with_ground(with_ground(left, Ground::off).value(), Ground::on).value();
  EXPECT_EQ(place(*again).lo, place(*whole).lo);
  EXPECT_EQ(place(*again).hi, place(*whole).hi);
  const Camera camera = first_camera(whole->world(), 16.0 / 9.0);
  EXPECT_EQ(picture(*again, camera, Method::sobol), picture(*left, camera, Method::sobol));
}

TEST(KnownSurfaces, AGroundBuildsOnlyItself) {
  const auto bare = ready(load_scene("builtin:office").value());
  Counts before;
  const auto on = with_ground(bare, Ground::on).value();
  before.surfaces += 48;
  EXPECT_EQ(Counts().surfaces, before.surfaces);
  EXPECT_LE(Counts().pairs, before.pairs + 48 * 48);
  before = Counts();
  const auto off = with_ground(on, Ground::off).value();
  EXPECT_EQ(Counts(), before);
  const Camera camera = first_camera(bare->world(), 16.0 / 9.0);
  for (const Method method : {Method::sobol, Method::asos})
    EXPECT_EQ(picture(*off, camera, method), picture(*bare, camera, method));
}

TEST(KnownSurfaces, LinesBuildOnlyThemselves) {
  Scene scene = load_scene("builtin:office").value();
  scene.instances.push_back({"line", static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
  scene.meshes.push_back(line_scenes::lines({{0, 0, 0}, {1, 2, 1}, {1, 0, 0}, {0, 2, 1}}));
  const auto bare = ready(scene);
  LinePicture seen{first_camera(bare->world(), 16.0 / 9.0), 27, 2.0};
  Counts before;
  const auto drawn = with_lines(bare, seen).value();
  EXPECT_LE(Counts().surfaces, before.surfaces + 8);
  EXPECT_GT(Counts().surfaces, before.surfaces);
  EXPECT_EQ(Counts().pairs, before.pairs);
  seen.width = 0.0;
  before = Counts();
  const auto cleared = with_lines(drawn, seen).value();
  EXPECT_EQ(Counts(), before);
  EXPECT_EQ(picture(*cleared, seen.camera, Method::sobol),
            picture(*bare, seen.camera, Method::sobol));
}

}  // namespace
}  // namespace asos::test::without_objects_test
