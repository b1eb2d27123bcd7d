#include "renderer/rays/back_face.h"
#include "renderer/rays/ray_scene.h"
#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/quad_mesh.h"
#include "tests/support/triangle_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace asos::faces_test {
namespace {

using test::add_square;
using test::build;
using test::double_sided;
using test::down;
using test::matte;

const Material grey = matte(glm::vec3(0.5f));
const Material grey_both = double_sided(grey);

/// The hits of one ray in all forms: single, and in the last lane of packets of each width.
std::vector<Hit> all_forms(RayScene& scene, const Ray& ray, Culling faces) {
  std::vector<Hit> found = {scene.closest(ray, faces)};
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<Ray> rays(19, down(50, 50));
    rays.back() = ray;
    std::vector<Hit> hits(rays.size());
    scene.closest(rays, hits, faces);
    for (std::size_t i = 0; i + 1 < rays.size(); ++i) EXPECT_FALSE(hits[i].valid());
    found.push_back(hits.back());
  }
  return found;
}

TEST(Culling, ARayGoesThroughTheBackOfASingleSidedSurface) {
  World world;
  add_square(world, 0.0f, grey, false);  // its back is up
  add_square(world, -1.0f, grey, true);
  RayScene scene = build(world);
  for (const Hit& hit : all_forms(scene, down(0.1f, 0.3f), Culling::as_material_says)) {
    EXPECT_FLOAT_EQ(hit.t, 2.0f);
    EXPECT_EQ(world.triangle_part[hit.triangle], 1u);
  }
  for (const Hit& hit : all_forms(scene, down(0.1f, 0.3f), Culling::none)) {
    EXPECT_FLOAT_EQ(hit.t, 1.0f);
  }
  // From below, the ray passes the second square's back and hits the first one's front.
  Ray up = down(0.1f, 0.3f, -5.0f);
  up.direction = {0, 0, 1};
  for (const Hit& hit : all_forms(scene, up, Culling::as_material_says)) {
    EXPECT_FLOAT_EQ(hit.t, 5.0f);
    EXPECT_EQ(world.triangle_part[hit.triangle], 0u);
  }
}

TEST(Culling, NothingBehindABackIsBackground) {
  World world;
  for (int i = 0; i < 100; ++i) add_square(world, -0.01f * static_cast<float>(i), grey, false);
  RayScene scene = build(world);
  for (const Hit& hit : all_forms(scene, down(0.1f, 0.3f), Culling::as_material_says)) {
    EXPECT_FALSE(hit.valid());
  }
}

TEST(Culling, DoubleSidedSurfacesShowTheirBack) {
  World world;
  add_square(world, 0.0f, grey, false);
  add_square(world, -1.0f, grey_both, false);
  add_square(world, -2.0f, grey, true);
  RayScene scene = build(world);
  for (const Hit& hit : all_forms(scene, down(0.1f, 0.3f), Culling::as_material_says)) {
    EXPECT_EQ(world.triangle_part[hit.triangle], 1u);
  }
}

TEST(Culling, AFrontInTheVeryPlaceOfABackIsMet) {
  // Leaves are often modelled as two single-sided squares of opposite windings in one plane.
  for (const bool back_first : {false, true}) {
    World world;
    add_square(world, 0.3f, grey, !back_first);
    add_square(world, 0.3f, grey, back_first);
    RayScene scene = build(world);
    std::mt19937 rng(4);
    std::uniform_real_distribution<float> side(-0.9f, 0.9f);
    for (int i = 0; i < 200; ++i) {
      Ray ray{.origin = {side(rng), side(rng), 1.7f}};
      ray.direction = glm::vec3(side(rng), side(rng), 0.3f) - ray.origin;
      for (const Hit& hit : all_forms(scene, ray, Culling::as_material_says)) {
        ASSERT_TRUE(hit.valid()) << i;
        EXPECT_EQ(world.triangle_part[hit.triangle], back_first ? 1u : 0u) << i;
      }
    }
  }
}

TEST(Culling, ShadowRaysMeetBothSides) {
  World world;
  add_square(world, 0.0f, grey, false);
  const RayScene scene = build(world);
  const Ray ray = down(0.1f, 0.3f);
  EXPECT_FALSE(scene.closest(ray, Culling::as_material_says).valid());
  EXPECT_EQ(scene.transmittance(ray).x, 0.0f);
  Blocker blocker;
  scene.blockers({&ray, 1}, {&blocker, 1});
  EXPECT_TRUE(blocker.hit.valid());
}

TEST(Culling, HolesAndBlendedSurfacesHaveBacksToo) {
  World world;
  Material glass = matte(glm::vec3(1));
  glass.transmission = 0.5f;
  add_square(world, 0.5f, test::blended(0.5f), false);
  add_square(world, 0.4f, test::masked(0.5f), false);
  add_square(world, 0.3f, glass, false);
  add_square(world, 0.2f, test::masked(2.0f), true);  // transparent everywhere
  add_square(world, 0.1f, test::blended(0.5f), true);
  add_square(world, 0.0f, grey, true);
  RayScene scene = build(world);
  for (const Hit& hit : all_forms(scene, down(0.1f, 0.3f), Culling::as_material_says)) {
    EXPECT_EQ(world.triangle_part[hit.triangle], 4u);
  }
}

/// A unit quad that faces +z, transformed by a matrix.
World placed_quad(const glm::dmat4& world_from_mesh) {
  Scene scene;
  test::add_object(scene, test::quad_mesh({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, -1), "",
                   world_from_mesh);
  return flatten(scene).value().world;
}

TEST(Culling, AMirroredInstanceKeepsItsFrontInFront) {
  const auto scaled = [](double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
  };
  struct Case {
    glm::dmat4 placed;
    bool front_up;
  };
  // In glTF, a mirroring across a plane that contains the normal keeps the front's direction; one
  // across the quad's own plane reverses it with the normal.
  for (const Case& c : {Case{scaled(1, 1, 1), true}, Case{scaled(-1, 1, 1), true},
                        Case{scaled(1, -2, 1), true}, Case{scaled(1, 1, -1), false},
                        Case{scaled(-1, -1, -1), false}, Case{scaled(-1, -1, 1), true}}) {
    const World world = placed_quad(c.placed);
    RayScene scene = build(world);
    const Ray ray = down(0.1f, 0.3f);
    for (const Hit& hit : all_forms(scene, ray, Culling::as_material_says)) {
      EXPECT_EQ(hit.valid(), c.front_up);
    }
    EXPECT_EQ(meets_back(world, 0, ray.direction), !c.front_up);
    // The winding agrees with the shading normals.
    EXPECT_EQ(world.normals[0].z > 0.0f, c.front_up);
  }
}

TEST(Culling, AgreeWithBruteForceInDouble) {
  World world = test::random_triangles(21, 250, 0.5f);
  for (std::size_t i = 0; i < world.materials.size(); i += 3) {
    world.materials[i].double_sided = true;
  }
  RayScene scene = build(world);
  std::mt19937 rng(22);
  std::vector<Ray> rays(1000);
  for (Ray& ray : rays) ray = test::random_ray(rng);
  int compared = 0;
  int culled = 0;
  for (const int width : {1, 4, 8, 16}) {
    scene.set_packet_width(width);
    std::vector<Hit> hits(rays.size());
    scene.closest(rays, hits, Culling::as_material_says);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const glm::dvec3 d(rays[i].direction);
      std::uint32_t expected = Hit::none;
      double nearest = std::numeric_limits<double>::infinity();
      double margin = 1.0;
      for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
        const auto met = test::crossing(world, t, glm::dvec3(rays[i].origin), d);
        if (!met || met->t < 0.0) continue;
        margin = std::min(margin, std::abs(met->inside()));
        const Part& part = world.parts[world.triangle_part[t]];
        const glm::uvec3 c = world.triangles[t];
        const glm::dvec3 p(world.positions[c.x]);
        // Counter-clockwise as seen from the eye: a positive volume.
        const double volume = glm::dot(
            glm::cross(glm::dvec3(world.positions[c.y]) - p, glm::dvec3(world.positions[c.z]) - p),
            glm::dvec3(rays[i].origin) - p);
        if (!world.materials[part.material].double_sided && volume < 0.0) continue;
        if (met->inside() >= 0.0 && met->t < nearest) {
          nearest = met->t;
          expected = t;
        }
      }
      if (margin < 1e-4) continue;
      ++compared;
      culled += scene.closest(rays[i]).triangle != expected;
      ASSERT_EQ(hits[i].triangle, expected) << "width " << width << " ray " << i;
      ASSERT_EQ(scene.closest(rays[i], Culling::as_material_says).triangle, expected) << i;
    }
  }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(culled, 300);
}

}  // namespace
}  // namespace asos::faces_test
