#include "renderer/comparison/whitted_spheres.h"
#include "renderer/sampling/random.h"
#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/make_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asos::test::whitted_test {
namespace {

RenderSettings whitted(int depth, bool spheres = false) {
  RenderSettings settings = settings_for(Method::whitted);
  settings.sampling.depth = depth;
  settings.sampling.spheres = spheres;
  return settings;
}

TEST(Whitted, AFlatPictureCostsOneRayForEachCorner) {
  const auto scene = make_render_scene(two_colours(12, {1, 1, 1}, {1, 1, 1}));
  RenderSettings settings = whitted(8);
  settings.width = 40;
  settings.height = 36;
  const Picture picture = render_picture(*scene, orthographic(8.0), settings);
  EXPECT_EQ(picture.statistics.eye_rays, 33u * 33u + 9u * 33u + 33u * 5u + 9u * 5u);
  EXPECT_EQ(picture.statistics.split_pixels, 0u);
  EXPECT_EQ(picture.statistics.pyrays_by_level[0], 40u * 36u);
  for (const glm::vec3& c : picture.film.radiance) EXPECT_EQ(c, glm::vec3(1));
}

TEST(Whitted, AVerticalEdgeIsFoundToHalfASquare) {
  for (const double share : {0.07, 0.3, 0.51, 0.94}) {
    const auto scene = make_render_scene(
        two_colours(4.0f + static_cast<float>(share), glm::vec3(1), glm::vec3(0)));
    for (int depth = 0; depth <= 6; ++depth) {
      const BlockResult r = render_small(*scene, whitted(depth));
      // Two corners of each square that the edge crosses are white.
      const double squares = std::ldexp(1.0, depth);
      const double expected = (std::floor(share * squares) + 0.5) / squares;
      for (int y = 0; y < 8; ++y) {
        EXPECT_NEAR(red_at(r, 4, y), expected, 1e-6) << share << ' ' << depth;
        EXPECT_EQ(red_at(r, 3, y), 1.0f);
        EXPECT_EQ(red_at(r, 5, y), 0.0f);
      }
      // Each level halves a column of 8 * 2^level squares: 3 new rays in each, one between two
      // neighbours, and one at each end. From level 6 on the squares of four pixels are kept at a
      // time, and both halves of the column trace the line between them.
      const auto levels = static_cast<unsigned>(depth);
      EXPECT_EQ(r.statistics.eye_rays,
                81u + 32u * ((1u << levels) - 1u) + (depth < 6 ? levels : 2u * levels));
      EXPECT_EQ(r.statistics.split_pixels, depth > 0 ? 8u : 0u);
      EXPECT_EQ(r.tile.split_level[4], depth);
      EXPECT_DOUBLE_EQ(r.statistics.unresolved_area, 8.0 / squares);
    }
  }
}

TEST(Whitted, ContrastIsThatOfTheCurve) {
  const auto scene = make_render_scene(two_colours(4.5f, glm::vec3(1.1f), glm::vec3(4)));
  RenderSettings settings = whitted(3);
  EXPECT_EQ(render_small(*scene, settings).statistics.split_pixels, 0u) << "both are white";
  settings.judged_tone = ToneCurve::agx;
  EXPECT_EQ(render_small(*scene, settings).statistics.split_pixels, 8u);
}

TEST(Whitted, OnlyContrastAboveTheThresholdIsSplit) {
  // Display intensities of 0.5 and 0.56 with the sRGB curve.
  const float low = 0.21404f, high = 0.27396f;
  const auto scene = make_render_scene(two_colours(4.4f, {0.5f, low, 0.5f}, {0.5f, high, 0.5f}));
  RenderSettings settings = whitted(3);
  settings.sampling.contrast = 0.065;
  EXPECT_EQ(render_small(*scene, settings).statistics.eye_rays, 81u);
  settings.sampling.contrast = 0.055;
  EXPECT_EQ(render_small(*scene, settings).statistics.split_pixels, 8u);
}

// With soft shadows each corner uses its own random number.
TEST(Whitted, ACornerDependsOnItsPlaceAndTheSeedAlone) {
  FlattenedScene still = still_life();
  still.lights.push_back(make_bulb({1, 3, 2}, 20.0f, 0.5));
  const auto scene = make_render_scene(std::move(still));
  const View view(look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), 64, 64);
  RenderSettings settings = whitted(3, true);
  settings.width = settings.height = 64;
  const BlockResult whole = render_block(*scene, view, settings, {0, 0, 32, 32});
  const BlockResult part = render_block(*scene, view, settings, {11, 20, 9, 7});
  int split = 0;
  for (int y = 20; y < 27; ++y) {
    for (int x = 11; x < 20; ++x) {
      EXPECT_NEAR(red_at(part, x, y), red_at(whole, x, y), 1e-5) << x << ' ' << y;
      split += part.tile.split_level[static_cast<std::size_t>((y - 20) * 9 + x - 11)] > 0;
    }
  }
  EXPECT_GT(split, 0);
  settings.seed = 1;
  EXPECT_NE(render_block(*scene, view, settings, {11, 20, 9, 7}).tile.radiance, part.tile.radiance);
}

/// A white rectangle in front of black, rotated about its centre, in pixels.
struct Needle {
  glm::dvec2 middle;
  glm::dvec2 half;
  double angle;

  [[nodiscard]] glm::dvec2 along() const { return {std::cos(angle), std::sin(angle)}; }
  [[nodiscard]] bool holds(glm::dvec2 p) const {
    const glm::dvec2 a = along(), d = p - middle;
    return std::abs(glm::dot(d, a)) < half.x && std::abs(a.x * d.y - a.y * d.x) < half.y;
  }
  [[nodiscard]] World world() const {
    World world;
    add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0)));
    const glm::vec2 x(2.0 * half.x * along());
    const glm::vec2 y(2.0 * half.y * glm::dvec2(-along().y, along().x));
    const glm::vec2 corner = glm::vec2(middle) - 0.5f * (x + y);
    add_quad(world, {corner.x - 4, 4 - corner.y, 1}, {x.x, -x.y, 0}, {y.x, -y.y, 0},
             unlit(glm::vec3(1)));
    for (Material& m : world.materials) m.double_sided = true;
    return world;
  }
};

double all_red(const BlockResult& result) {
  double sum = 0.0;
  for (const glm::vec3& c : result.tile.radiance) sum += static_cast<double>(c.r);
  return sum;
}

/// The covered area in pixels by counting the finest corners, if the whole picture is split.
double covered(const Needle& needle, int depth) {
  const int side = 8 << depth;
  int count = 0;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x)
      count += needle.holds({std::ldexp(x, -depth), std::ldexp(y, -depth)});
  }
  return std::ldexp(count, -2 * depth);
}

TEST(Whitted, SpheresFindADotInEveryPlace) {
  constexpr int depth = 4;
  int lost = 0;
  for (int i = 0; i < 49; ++i) {
    const glm::dvec2 at(4.013 + (i % 7) / 7.0, 3.017 + (i / 7) / 7.0);
    const Needle dot{at, {0.15, 0.15}, 0.0};
    const auto scene = make_render_scene(dot.world());
    const BlockResult found = render_small(*scene, whitted(depth, true));
    EXPECT_NEAR(all_red(found), covered(dot, depth), 1e-5) << at.x << ' ' << at.y;
    EXPECT_GT(all_red(found), 0.0);
    // Only a few pixels are searched for the dot.
    EXPECT_LE(found.statistics.split_pixels, 16u);

    const glm::dvec2 in_pixel = at - glm::floor(at);
    const bool slips =
        std::min(in_pixel.x, in_pixel.y) > 0.15 && std::max(in_pixel.x, in_pixel.y) < 0.85;
    if (!slips) continue;
    ++lost;
    const BlockResult missed = render_small(*scene, whitted(depth));
    EXPECT_EQ(all_red(missed), 0.0);
    EXPECT_EQ(missed.statistics.eye_rays, 81u);
  }
  EXPECT_EQ(lost, 25);
}

TEST(Whitted, SpheresFindANeedleInEveryDirection) {
  constexpr int depth = 5;
  for (int i = 0; i < 24; ++i) {
    const RandomPair at = unit_pair(pixel_random(i, 0, 1));
    const Needle needle{{3.5 + at.u, 3.5 + at.v}, {1.5, 0.06}, 0.13 + 0.131 * i};
    const auto scene = make_render_scene(needle.world());
    const double found = all_red(render_small(*scene, whitted(depth, true)));
    EXPECT_NEAR(found, covered(needle, depth), 1e-4) << needle.angle;
    EXPECT_GT(found, 0.0);
  }
}

TEST(Whitted, SpheresFindADotInPerspective) {
  RenderSettings settings = whitted(3, true);
  settings.width = 30;
  settings.height = 20;
  const Camera camera = look_at({1, 2, 3}, {0, 0, -4}, 1.9);
  const View view(camera, settings.width, settings.height);
  for (int i = 0; i < 40; ++i) {
    const RandomPair at = unit_pair(pixel_random(i, 0, 2));
    const RandomPair more = unit_pair(pixel_random(i, 0, 3));
    const double x = 1.0 + 28.0 * at.u, y = 1.0 + 18.0 * at.v;
    const double distance = 2.0 + 50.0 * more.u;
    const auto point = [&](double dx, double dy) {
      const Ray ray = view.ray(x + dx, y + dy);
      return ray.at(static_cast<float>(distance));
    };
    World world;
    Material white = unlit(glm::vec3(100));
    white.double_sided = true;
    add_triangle(world, point(-0.2, -0.2), point(0.3, -0.1), point(0, 0.3), white);
    const Picture picture = render_picture(*make_render_scene(std::move(world)), camera, settings);
    const auto& pixels = picture.film.radiance;
    EXPECT_GT(std::max_element(pixels.begin(), pixels.end(),
                               [](glm::vec3 a, glm::vec3 b) { return a.r < b.r; })
                  ->r,
              1.0f)
        << x << ' ' << y << ' ' << distance;
  }
}

TEST(Whitted, SpheresOfWhatIsHiddenOrLargeSplitNothing) {
  const Needle dot{{4.5, 4.5}, {0.1, 0.1}, 0.0};
  World hidden = dot.world();
  add_card(hidden, {-9, -9}, {17, 17}, unlit(glm::vec3(0)), 2.0f);
  const auto scene = make_render_scene(std::move(hidden));
  EXPECT_EQ(render_small(*scene, whitted(4, true)).statistics.eye_rays, 81u);

  const View view(orthographic(8.0), 8, 8);
  const auto spheres = object_spheres(scene->world());
  ASSERT_EQ(spheres.size(), 3u);
  EXPECT_NEAR(spheres[1].radius, std::sqrt(0.02), 1e-6);
  EXPECT_NEAR(spheres[1].thickness, std::sqrt(0.02), 1e-6);
  EXPECT_FALSE(EnlargedSpheres(spheres, view, small_block).empty());
  EXPECT_TRUE(EnlargedSpheres(std::span(spheres).first(1), view, small_block).empty());
  // A sphere far from the block is ignored, too.
  EXPECT_TRUE(EnlargedSpheres(spheres, view, {400, 0, 8, 8}).empty());
}

}  // namespace
}  // namespace asos::test::whitted_test
