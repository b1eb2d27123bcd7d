#include "renderer/comparison/disk_area.h"
#include "renderer/comparison/method.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Cone tracing, covers and coverage masks as the papers describe them (CGF'98 sections 2.7, 2.8 and
// 2.12): their correct results and their known errors, against closed forms.

namespace asos::test::polygon_methods_test {
namespace {

/// Pixels are 1 x 1; pixel (4, 4) of 8 x 8 is 0 to 1 by -1 to 0 in the world.
struct Wall {
  float left, right;  ///< range in x, over the whole height
  float z;
  glm::vec3 colour;
};

glm::vec3 pixel_by(Method method, const std::vector<Wall>& walls) {
  World world;
  add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, unlit({0, 0, 1}));
  for (const Wall& wall : walls)
    add_quad(world, {wall.left, -20, wall.z}, {wall.right - wall.left, 0, 0}, {0, 40, 0},
             unlit(wall.colour));
  const auto scene = make_render_scene(std::move(world));
  const RenderSettings settings = make_settings(8, 8, method);
  const BlockResult r = render_block(*scene, View(orthographic(8.0), 8, 8), settings, {0, 0, 8, 8});
  return r.tile.radiance[8 * 4 + 4];
}

constexpr glm::vec3 red{1, 0, 0}, green{0, 1, 0};
constexpr float tolerance = 1e-5f;

/// Fraction of a disk of area 1 around (0.5, 0.5) that is left of x.
double disk_left_of(double x) {
  const double r = 1.0 / std::sqrt(std::numbers::pi), d = x - 0.5;
  return 0.5 + (d * std::sqrt(r * r - d * d) + r * r * std::asin(d / r));
}

// A wall over the left 0.3 of the pixel.
TEST(PolygonMethods, WeighOneEdgeByTheirOwnRule) {
  const std::vector<Wall> walls{{-20, 0.3f, 0, red}};
  EXPECT_NEAR(pixel_by(Method::beam, walls).r, 0.3, tolerance);
  EXPECT_NEAR(pixel_by(Method::cone, walls).r, disk_left_of(0.3), tolerance);
  EXPECT_NEAR(pixel_by(Method::covers, walls).r, 0.5 - 0.2, tolerance);
  EXPECT_NEAR(pixel_by(Method::mask, walls).r, 2.0 / 8.0, tolerance);
}

// Two walls cover the same half, so the second one is hidden. Coverage fractions cannot represent
// this.
TEST(PolygonMethods, FractionsCountWhatIsHiddenBehindEachOther) {
  const std::vector<Wall> walls{{-20, 0.5f, 0, red}, {-20, 0.5f, -2, green}};
  for (const Method exact : {Method::beam, Method::mask}) {
    EXPECT_NEAR(pixel_by(exact, walls).r, 0.5, tolerance);
    EXPECT_NEAR(pixel_by(exact, walls).g, 0.0, tolerance);
    EXPECT_NEAR(pixel_by(exact, walls).b, 0.5, tolerance);
  }
  for (const Method fraction : {Method::cone, Method::covers}) {
    EXPECT_NEAR(pixel_by(fraction, walls).r, 0.5, tolerance);
    EXPECT_NEAR(pixel_by(fraction, walls).g, 0.25, tolerance);
    EXPECT_NEAR(pixel_by(fraction, walls).b, 0.25, tolerance);
  }
}

// Two adjacent walls cover all of the pixel; by fractions a quarter of it shows the blue wall.
TEST(PolygonMethods, FractionsLetTheBackgroundThroughBesideEachOther) {
  const std::vector<Wall> walls{{-20, 0.5f, 0, red}, {0.5f, 20, -2, green}};
  for (const Method exact : {Method::beam, Method::mask}) {
    EXPECT_NEAR(pixel_by(exact, walls).g, 0.5, tolerance);
    EXPECT_NEAR(pixel_by(exact, walls).b, 0.0, tolerance);
  }
  for (const Method fraction : {Method::cone, Method::covers}) {
    EXPECT_NEAR(pixel_by(fraction, walls).r, 0.5, tolerance);
    EXPECT_NEAR(pixel_by(fraction, walls).g, 0.25, tolerance);
    EXPECT_NEAR(pixel_by(fraction, walls).b, 0.25, tolerance);
  }
}

// A wire of a tenth of a pixel, through the centre and off it, between two columns of points.
TEST(PolygonMethods, ThinObjectsShowEachMethodsFault) {
  const std::vector<Wall> centred{{0.45f, 0.55f, 0, red}}, between{{0.7f, 0.8f, 0, red}};
  EXPECT_NEAR(pixel_by(Method::beam, centred).r, 0.1, tolerance);
  EXPECT_NEAR(pixel_by(Method::cone, centred).r, disk_left_of(0.55) - disk_left_of(0.45),
              tolerance);
  EXPECT_NEAR(pixel_by(Method::covers, centred).r, 0.55, tolerance) << "0.05 to its edge";
  EXPECT_NEAR(pixel_by(Method::covers, between).r, 0.3, tolerance) << "0.2 to its edge";
  EXPECT_NEAR(pixel_by(Method::mask, centred).r, 0.0, tolerance) << "no point within it";
  EXPECT_NEAR(pixel_by(Method::mask, between).r, 0.0, tolerance);
}

// A matte wall under a large light: each shadow ray has the weight of its part of the light.
TEST(PolygonMethods, SumLightsOfAnySizeOnce) {
  FlattenedScene scene;
  add_quad(scene.world, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, matte(glm::vec3(0.5f)));
  scene.lights.push_back(make_panel({0, 0, 4}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 3.0f));
  const auto lit = make_render_scene(std::move(scene));
  const auto centre = [&](Method method, int spp) {
    const RenderSettings settings = make_settings(8, 8, method, spp);
    const BlockResult r = render_block(*lit, View(orthographic(2.0), 8, 8), settings, {0, 0, 8, 8});
    return r.tile.radiance[8 * 4 + 4].g;
  };
  const float truth = centre(Method::asos, 1);
  ASSERT_GT(truth, 0.05f);
  for (const Method method : {Method::beam, Method::cone, Method::covers, Method::mask}) {
    EXPECT_NEAR(centre(method, 1), truth, 0.05f * truth) << row_of(method).name;
    EXPECT_NEAR(centre(method, 64), truth, 0.01f * truth) << row_of(method).name;
  }
}

TEST(AreaInDisk, IsExact) {
  const double r = 0.5, all = std::numbers::pi * r * r;
  const auto rectangle = [](double x0, double y0, double x1, double y1) {
    return ConvexPolygon{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  };
  const glm::dvec2 centre(0.25, -0.5);
  EXPECT_NEAR(area_in_disk(rectangle(-9, -9, 9, 9), centre, r), all, 1e-12);
  EXPECT_NEAR(area_in_disk(rectangle(0.2, -0.6, 0.3, -0.4), centre, r), 0.02, 1e-12);
  EXPECT_NEAR(area_in_disk(rectangle(-9, -9, 0.25, 9), centre, r), 0.5 * all, 1e-12);
  EXPECT_NEAR(area_in_disk(rectangle(0.25, -0.5, 9, 9), centre, r), 0.25 * all, 1e-12);
  EXPECT_NEAR(area_in_disk(rectangle(1, 1, 9, 9), centre, r), 0.0, 1e-12);
  // A segment of height 0.1.
  const double d = 0.4;
  EXPECT_NEAR(area_in_disk(rectangle(0.25 + d, -9, 9, 9), centre, r),
              r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d), 1e-12);
}

}  // namespace
}  // namespace asos::test::polygon_methods_test
