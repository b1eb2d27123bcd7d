#include "renderer/rays/coplanar.h"
#include "renderer/work_counts.h"
#include "renderer/world/ground.h"
#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

// Worlds that share surfaces with a known one use its hierarchies and marks again. The results are
// those of a world that was built alone.

namespace asos::test::known_layers_test {
namespace {

/// Squares with decals on them, of all kinds of surfaces, and loose triangles. Each part has a
/// number.
World numbered_world() {
  World world = random_triangles(7, 40, 0.4f);
  const Material grey = matte(glm::vec3(0.5f));
  for (int i = 0; i < 6; ++i) {
    const float z = 0.3f * static_cast<float>(i) - 0.8f;
    add_square(world, z, i % 2 == 0 ? double_sided(grey) : grey);
    add_quad(world, {-0.5f, -0.5f, z}, {1, 0, 0}, {0, 1, 0}, i % 3 == 0 ? blended(0.5f) : grey);
    add_quad(world, {-0.2f, -0.2f, z}, {0.4f, 0, 0}, {0, 0.4f, 0},
             i % 3 == 1 ? masked(0.5f) : grey);
  }
  for (Part& part : world.parts) part.surfaces = new_surfaces_id();
  return world;
}

std::vector<std::uint8_t> every(std::size_t nth, std::size_t first, const World& world) {
  std::vector<std::uint8_t> hidden(world.parts.size(), 0);
  for (std::size_t i = first; i < hidden.size(); i += nth) hidden[i] = 1;
  return hidden;
}

RayScene built_from(const World& world, const RayScene& known,
                    const std::vector<Light>& lights = {}) {
  auto built =
      RayScene::build(world, factor_alpha, lights, {}, nullptr, BvhPurpose::lasting, &known);
  EXPECT_TRUE(built.has_value());
  return *std::move(built);
}

/// Expects the same results for random rays, one by one and in packets.
void expect_same(const RayScene& a, const RayScene& b, std::int32_t ignored = -1) {
  std::mt19937 rng(3);
  for (int round = 0; round < 40; ++round) {
    std::vector<Ray> rays(round % 3 == 0 ? 1 : 37);
    for (Ray& ray : rays) ray = random_ray(rng);
    const Culling faces = round % 2 == 0 ? Culling::none : Culling::as_material_says;
    std::vector<Hit> of_a(rays.size()), of_b(rays.size());
    a.closest(rays, of_a, faces);
    b.closest(rays, of_b, faces);
    std::vector<glm::vec3> light_a(rays.size()), light_b(rays.size());
    a.transmittance(rays, light_a, ignored);
    b.transmittance(rays, light_b, ignored);
    std::vector<Blocker> block_a(rays.size()), block_b(rays.size());
    a.blockers(rays, block_a, ignored);
    b.blockers(rays, block_b, ignored);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      ASSERT_EQ(of_a[i].triangle, of_b[i].triangle) << round << " " << i;
      ASSERT_EQ(of_a[i].t, of_b[i].t);
      ASSERT_EQ(of_a[i].b1, of_b[i].b1);
      ASSERT_EQ(a.is_coplanar(of_a[i]), b.is_coplanar(of_b[i]));
      ASSERT_EQ(light_a[i], light_b[i]);
      ASSERT_EQ(block_a[i].hit.t, block_b[i].hit.t);
      // Any of several surfaces in one place may block.
      if (!b.is_coplanar(block_b[i].hit)) {
        ASSERT_EQ(block_a[i].hit.triangle, block_b[i].hit.triangle);
      }
      ASSERT_EQ(block_a[i].transmittance, block_b[i].transmittance);
      ASSERT_EQ(block_a[i].see_through, block_b[i].see_through);
      std::vector<Hit> met_a, met_b;
      if (!b.is_coplanar(of_b[i])) continue;
      a.in_place(rays[i], of_a[i], faces, met_a);
      b.in_place(rays[i], of_b[i], faces, met_b);
      ASSERT_EQ(met_a.size(), met_b.size());
      for (std::size_t k = 0; k < met_a.size(); ++k)
        ASSERT_EQ(met_a[k].triangle, met_b[k].triangle);
    }
  }
}

TEST(KnownLayers, HideWithoutANewHierarchy) {
  const World whole = numbered_world();
  const std::vector<Light> lights{lamp_of(41)};
  const RayScene rays = build(whole, factor_alpha, lights);
  for (const std::size_t nth : {2u, 3u, 7u}) {
    const World left = without_parts(whole, every(nth, 1, whole));
    std::int32_t part = 41;
    for (int i = 0; i < 41; ++i) part -= every(nth, 1, whole)[static_cast<std::size_t>(i)] ? 1 : 0;
    const bool hidden = every(nth, 1, whole)[41] != 0;
    const std::vector<Light> left_lights =
        hidden ? std::vector<Light>{} : std::vector<Light>{lamp_of(part)};
    const std::uint64_t before = WorkDone::of(Work::hierarchy_surfaces);
    const RayScene fast = built_from(left, rays, left_lights);
    EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before);
    expect_same(fast, build(left, factor_alpha, left_lights), hidden ? -1 : part);
  }
}

// A light's own part has a geometry of its own.
TEST(KnownLayers, AreBuiltAgainForOtherLights) {
  const World world = numbered_world();
  const RayScene rays = build(world);
  const std::uint64_t before = WorkDone::of(Work::hierarchy_surfaces);
  const std::vector<Light> lights{lamp_of(41)};
  const RayScene lit = built_from(world, rays, lights);
  EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before + world.triangles.size());
  expect_same(lit, build(world, factor_alpha, lights), 41);
}

TEST(KnownLayers, OutliveTheirWorld) {
  RayScene rays;
  World left;
  {
    const auto whole = std::make_unique<World>(numbered_world());
    const RayScene known = build(*whole);
    left = without_parts(*whole, every(3, 0, *whole));
    rays = built_from(left, known);
  }
  expect_same(rays, build(left));
}

TEST(KnownLayers, AddAGround) {
  const World bare = numbered_world();
  const RayScene rays = build(bare);
  World grounded = bare;
  put_on_ground(grounded, Ground::on);
  std::uint64_t before = WorkDone::of(Work::hierarchy_surfaces);
  const RayScene on_ground = built_from(grounded, rays);
  EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before + 48);
  expect_same(on_ground, build(grounded));

  World again = grounded;
  put_on_ground(again, Ground::off);
  before = WorkDone::of(Work::hierarchy_surfaces);
  expect_same(built_from(again, on_ground), rays);
  EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before);
}

TEST(KnownLayers, HideShapes) {
  World whole = numbered_world();
  for (int i = 0; i < 4; ++i) {
    Shape shape{.type = Shape::Type::sphere, .radius = 0.3};
    glm::dmat4 place(1.0);
    place[3] = {0.5 * i - 0.75, 0.2, 0.1, 1.0};
    add_shape(whole, shape, place, i % 2 == 0 ? matte(glm::vec3(0.5f)) : blended(0.3f));
    whole.parts.back().surfaces = new_surfaces_id();
  }
  const RayScene rays = build(whole);
  const World left = without_parts(whole, every(2, 0, whole));
  EXPECT_EQ(left.faces.size(), 2u);
  const std::uint64_t before = WorkDone::of(Work::hierarchy_surfaces);
  const RayScene fast = built_from(left, rays);
  EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before);
  expect_same(fast, build(left));
}

TEST(KnownLayers, HideInstancesOfSharedMeshes) {
  const Scene scene = instanced_scene(40, 60);
  const World whole = flatten(scene).value().world;
  ASSERT_TRUE(whole.placements);
  const RayScene rays = build(whole);
  for (const std::size_t nth : {2u, 5u}) {
    const World left = without_parts(whole, every(nth, 1, whole));
    EXPECT_LT(left.placements->places.size(), whole.placements->places.size());
    const std::uint64_t before = WorkDone::of(Work::hierarchy_surfaces);
    const RayScene fast = built_from(left, rays);
    EXPECT_EQ(WorkDone::of(Work::hierarchy_surfaces), before);
    expect_same(fast, build(left));
  }
}

/// Returns the marks as a search without knowledge finds them.
std::vector<std::uint8_t> marks_of(const tracing::Coplanar& found, const World& world) {
  std::vector<std::uint8_t> marks = found.by_triangle;
  marks.resize(world.triangles.own_size());
  return marks;
}

TEST(KnownMarks, AreThoseOfANewSearch) {
  const World whole = numbered_world();
  const tracing::Coplanar known = tracing::find_coplanar(whole);
  ASSERT_FALSE(known.empty());
  for (const std::size_t nth : {2u, 3u, 4u, 5u, 11u}) {
    const World left = without_parts(whole, every(nth, 2, whole));
    const tracing::Coplanar found = tracing::find_coplanar(left, &whole, &known);
    const tracing::Coplanar anew = tracing::find_coplanar(left);
    EXPECT_EQ(marks_of(found, left), marks_of(anew, left)) << nth;
    EXPECT_LE(found.compared, anew.compared);
    // And back: the shown parts are compared with the others.
    const tracing::Coplanar shown = tracing::find_coplanar(whole, &left, &found);
    EXPECT_EQ(marks_of(shown, whole), marks_of(known, whole)) << nth;
    EXPECT_LE(shown.compared, known.compared);
  }
}

TEST(KnownMarks, OfTheSameSurfacesCompareNothing) {
  const World whole = numbered_world();
  const tracing::Coplanar known = tracing::find_coplanar(whole);
  EXPECT_GT(known.compared, 0u);
  const tracing::Coplanar found = tracing::find_coplanar(whole, &whole, &known);
  EXPECT_EQ(found.compared, 0u);
  EXPECT_EQ(marks_of(found, whole), marks_of(known, whole));
  // Loose triangles have no partners.
  std::vector<std::uint8_t> hidden(whole.parts.size(), 0);
  std::fill_n(hidden.begin(), 40, std::uint8_t{1});
  const World left = without_parts(whole, hidden);
  EXPECT_EQ(tracing::find_coplanar(left, &whole, &known).compared, 0u);
}

}  // namespace
}  // namespace asos::test::known_layers_test
