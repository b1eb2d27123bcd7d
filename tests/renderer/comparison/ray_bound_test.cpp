#include "renderer/sampling/random.h"
#include "tests/renderer/comparison/rival_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace asos::test::ray_bound_test {
namespace {

TEST(RayBound, TakesAllSamplesAtABoundaryAndOneElsewhere) {
  // The line cuts off the first of n columns of samples for n = 4, and is far from centres.
  const auto scene = make_render_scene(two_colours(4.25f, glm::vec3(1), glm::vec3(0)));
  for (const int spp : {1, 4, 9, 16, 60}) {
    const BlockResult r = render_small(*scene, settings_for(Method::ray_bound, spp));
    const int n = static_cast<int>(std::ceil(std::sqrt(spp)));
    EXPECT_EQ(r.statistics.eye_rays, 56u + 8u * static_cast<unsigned>(n * n)) << spp;
    EXPECT_EQ(r.statistics.split_pixels, n > 1 ? 8u : 0u);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x)
        EXPECT_EQ(r.tile.split_level[static_cast<std::size_t>(8 * y + x)], x == 4 && n > 1) << spp;
      EXPECT_EQ(red_at(r, 3, y), 1.0f);
      EXPECT_EQ(red_at(r, 5, y), 0.0f);
      if (n == 4) {
        EXPECT_NEAR(red_at(r, 4, y), 0.25f, 1e-6);
      }
    }
  }
}

TEST(RayBound, AFlatPictureCostsOneRayAPixel) {
  const auto scene = make_render_scene(two_colours(12, glm::vec3(1), glm::vec3(1)));
  const BlockResult r = render_small(*scene, settings_for(Method::ray_bound));
  EXPECT_EQ(r.statistics.eye_rays, 64u);
}

TEST(RayBound, SamplesConvergeOnTheCoverageOfAnObliqueEdge) {
  // The half-plane left of x = 4.2 + 0.2 y, in pixel (4, 2): 0.2 + 0.2 * 2.5 = 0.7 wide on average.
  World world;
  add_part(world,
           {{{0.2f - 8, 4, 0}, {0, 0, 1}, {}},
            {{0.2f - 8, -12, 0}, {0, 0, 1}, {}},
            {{0.2f + 0.2f * 16, -12, 0}, {0, 0, 1}, {}},
            {{0.2f, 4, 0}, {0, 0, 1}, {}}},
           {{0, 1, 2}, {0, 2, 3}}, unlit(glm::vec3(1)));
  const auto scene = make_render_scene(std::move(world));
  for (const int spp : {16, 256, 4096}) {
    const BlockResult r = render_small(*scene, settings_for(Method::ray_bound, spp));
    const double n = std::sqrt(spp);
    // Five standard deviations of about 1.3 n strata, plus the one whose sample is replaced by the
    // centre's.
    const double bound = (1.0 - sky_radiance) * (5.0 * std::sqrt(1.3 * n * 0.25) + 1.0) / (n * n);
    EXPECT_NEAR(red_at(r, 4, 2), 0.7 + 0.3 * sky_radiance, bound) << spp;
  }
}

TEST(RayBound, FindsUnsampledButNotHiddenObjects) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0)));
  add_card(world, {2.03f, 5.04f}, {2.06f, 5.07f}, unlit(glm::vec3(1)), 1.0f);
  World hidden = world;
  const auto scene = make_render_scene(std::move(world));
  const BlockResult r = render_small(*scene, settings_for(Method::ray_bound));
  EXPECT_EQ(r.statistics.eye_rays, 63u + 16u);
  EXPECT_EQ(r.tile.split_level[8 * 5 + 2], 1);

  add_card(hidden, {-9, -9}, {17, 17}, unlit(glm::vec3(0)), 40.0f);
  Camera far = orthographic(8.0);
  far.world_from_camera[3].z = 100.0;
  const auto behind = make_render_scene(std::move(hidden));
  EXPECT_EQ(render_block(*behind, View(far, 8, 8), settings_for(Method::ray_bound), small_block)
                .statistics.eye_rays,
            64u);
}

/// Number of surfaces that n x n rays through a pixel hit.
std::size_t surfaces_in(const RenderScene& scene, const View& view, int x, int y, int n) {
  std::set<std::uint32_t> surfaces;
  for (int k = 0; k < n * n; ++k) {
    const Ray ray = view.ray(x + (k % n + 0.5) / n, y + (k / n + 0.5) / n);
    const Hit hit = scene.rays().closest(ray, Culling::as_material_says);
    surfaces.insert(hit.valid() ? scene.features().smooth_surface(hit.triangle) : Hit::none);
  }
  return surfaces.size();
}

struct Findings {
  int bounded = 0;
  int differ = 0;                    // pixels whose rays hit more than one surface
  int unbounded = 0;                 // those of them without a detected edge
  std::vector<glm::ivec2> doubtful;  // pixels with an edge that no ray confirms
};

constexpr int size = 44;

View square_view() {
  return View(look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), size, size);
}

Findings compare(const RenderScene& scene) {
  const View view = square_view();
  Findings found;
  for (int by = 0; by < size; by += 8) {
    for (int bx = 0; bx < size; bx += 8) {
      const PixelRect block{bx, by, std::min(8, size - bx), std::min(8, size - by)};
      const BlockResult r =
          render_block(scene, view, settings_for(Method::ray_bound, 4, size), block);
      for (int i = 0; i < block.width * block.height; ++i) {
        const int x = bx + i % block.width, y = by + i / block.width;
        const bool bounded = r.tile.split_level[static_cast<std::size_t>(i)] > 0;
        const bool differ = surfaces_in(scene, view, x, y, 24) > 1;
        found.bounded += bounded;
        found.differ += differ;
        found.unbounded += differ && !bounded;
        if (bounded && !differ) found.doubtful.emplace_back(x, y);
      }
    }
  }
  return found;
}

TEST(RayBound, MissesNoPixelWhereRaysDiffer) {
  const Findings found = compare(*make_render_scene(still_life()));
  EXPECT_GT(found.differ, 100);
  EXPECT_EQ(found.unbounded, 0);
}

// Pixels whose rays differ have a boundary, if occluders are a few pixel widths in front.
TEST(RayBound, BoundariesAreWhereRaysDiffer) {
  World world;
  for (int i = 0; i < 6; ++i) {
    const auto at = [&](int k) {
      const RandomPair r = unit_pair(pixel_random(i, k, 6));
      return glm::vec3(3.0 * r.u - 1.7, 3.0 * r.v - 0.9, -3.0 * i);
    };
    Material material = unlit(glm::vec3(1));
    material.double_sided = true;
    add_triangle(world, at(0), at(1), at(2), material);
  }
  const auto scene = make_render_scene(std::move(world));
  const Findings found = compare(*scene);
  EXPECT_GT(found.differ, 100);
  EXPECT_EQ(found.unbounded, 0);
  // Some edges touch only a corner of their pixel.
  for (const glm::ivec2 p : found.doubtful)
    EXPECT_TRUE(surfaces_in(*scene, square_view(), p.x, p.y, 300) > 1 ||
                surfaces_in(*scene, square_view(), p.x, p.y, 2000) > 1)
        << p.x << ' ' << p.y;
}

}  // namespace
}  // namespace asos::test::ray_bound_test
