#include "renderer/comparison/method.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asos::blurred_mirror_test {
namespace {

using test::add_quad;
using test::look_at;
using test::make_render_scene;
using test::unlit;

constexpr int side = 48;
constexpr double distance = 4.0;  // from the camera to the mirror
constexpr double height = 6.0;    // of the mirrored object
constexpr double fov = 0.06;      // so narrow that all rays hit the mirror at right angles

/// Looks straight down at a mirror in y = 0, which reflects objects at y = 6.
Camera from_above() {
  Camera camera = look_at({0, distance, 0}, {0, 0, -1e-9}, fov);
  // +X to the right, -Z up.
  camera.world_from_camera = glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0),
                                        glm::dvec4(0, 1, 0, 0), glm::dvec4(0, distance, 0, 1));
  return camera;
}

Material mirror() {
  return {.base_color = glm::vec4(1.0f), .metallic = 1.0f, .roughness = 0.0f, .double_sided = true};
}

void blur(Material& m, double dfr) {
  m.dfr.emplace();
  m.dfr->rgb.fill({dfr, dfr, 1.0});
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = test::make_settings(side, side, method);
  settings.crop = {0, side / 2, side, 1};
  settings.asos.eps = 0.0;
  return settings;
}

/// Integral up to x of the convolution of two boxes of widths a and b.
double below(double x, double a, double b) {
  const auto ramp2 = [](double y) { return y > 0.0 ? 0.5 * y * y : 0.0; };
  const double s = 0.5 * (a + b), d = 0.5 * (a - b);
  if (!(std::min(a, b) > 0.0)) return std::clamp(x / std::max(a, b) + 0.5, 0.0, 1.0);
  return (ramp2(x + s) - ramp2(x + d) - ramp2(x - d) + ramp2(x - s)) / (a * b);
}

struct Edge {
  double at = 0.0013;
  double width = 0.0;  // of the lobe, at distance 1

  /// Fraction of the pixel in this column that the dark half-plane x < at covers.
  [[nodiscard]] double covered(int column) const {
    const double pixel = 2.0 * std::tan(0.5 * fov) / side;
    const double middle = (column + 0.5 - 0.5 * side) * pixel * (distance + height);
    return below(at - middle, pixel * (distance + height), width * height);
  }
};

std::vector<double> middle_row(const World& world, const RenderSettings& settings) {
  const auto scene = make_render_scene(World(world));
  const Film film = test::render_picture(*scene, from_above(), settings).film;
  std::vector<double> row;
  for (int x = 0; x < side; ++x)
    row.push_back(static_cast<double>(film.radiance[film.index(x, side / 2)].x));
  return row;
}

World half_plane(const Material& material, double at) {
  World world;
  add_quad(world, {-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, material);
  Material dark = unlit({0.0f, 0.0f, 0.0f});
  dark.double_sided = true;
  add_quad(world, {-9, static_cast<float>(height), 9}, {9 + static_cast<float>(at), 0, 0},
           {0, 0, -18}, dark);
  return world;
}

class EveryBlur : public testing::TestWithParam<double> {};

// An edge in a blurred mirror has the profile of a convolution: the pixel's box with the lobe's.
TEST_P(EveryBlur, HalfPlaneMatchesClosedForm) {
  Material material = mirror();
  blur(material, GetParam());
  Edge edge;
  const double pixel = 2.0 * std::tan(0.5 * fov) / side;
  edge.width = pixel * (1.0 / GetParam() - 1.0);
  const auto row = middle_row(half_plane(material, edge.at), settings_of(Method::asos));
  const double sky = static_cast<double>(sky_radiance);
  for (int x = 0; x < side; ++x)
    EXPECT_NEAR(row[static_cast<std::size_t>(x)] / sky, 1.0 - edge.covered(x), 1e-3) << x;
}

INSTANTIATE_TEST_SUITE_P(Ratios, EveryBlur, testing::Values(1.0, 0.9, 0.5, 0.2, 0.05));

TEST(BlurredMirror, MatchesSampledReflection) {
  Material material = mirror();
  blur(material, 0.2);
  Edge edge;
  edge.width = 2.0 * std::tan(0.5 * fov) / side * 4.0;
  RenderSettings settings = settings_of(Method::sobol);
  settings.sampling.spp = 4096;
  // The standard deviation of as many independent samples.
  const double deviation = 0.5 / std::sqrt(settings.sampling.spp);
  const auto row = middle_row(half_plane(material, edge.at), settings);
  const double sky = static_cast<double>(sky_radiance);
  for (int x = 0; x < side; ++x)
    EXPECT_NEAR(row[static_cast<std::size_t>(x)] / sky, 1.0 - edge.covered(x), deviation) << x;
}

// A mirror meets a wall in a corner that runs through all pixels from side to side. Half of the
// rectangle around a leaf would be behind the wall, where nothing is reflected.
TEST(BlurredMirror, StaysWithinTheLeafAtACorner) {
  World world;
  Material blurred = mirror();
  blur(blurred, 0.0125);
  blurred.double_sided = false;
  add_quad(world, {0, 0, 40}, {40, 0, 0}, {0, 0, -80}, blurred);
  Material wall = unlit(glm::vec3(1.0f));
  wall.double_sided = false;
  add_quad(world, {0, 0, 40}, {0, 0, -80}, {0, 40, 0}, wall);
  const auto scene = make_render_scene(std::move(world));
  // Looks along the floor of the corner, rotated by 45 degrees about the view's target.
  Camera camera = look_at({4, 3, 0}, {0, 0, 0}, 0.03);
  camera.world_from_camera = camera.world_from_camera *
                             glm::dmat4(glm::dmat3(std::sqrt(0.5), std::sqrt(0.5), 0,
                                                   -std::sqrt(0.5), std::sqrt(0.5), 0, 0, 0, 1));
  RenderSettings settings = test::make_settings(12, 12);
  settings.asos.max_level = 2;
  settings.asos.eps = 1.0 / 256.0;
  const Film film = test::render_picture(*scene, camera, settings).film;
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  const Film truth = test::render_picture(*scene, camera, settings).film;
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x)
      EXPECT_NEAR(film.radiance[film.index(x, y)].x, truth.radiance[film.index(x, y)].x, 0.01f)
          << x << " " << y;
}

TEST(BlurredMirror, BlursColoursByTheirOwnCurves) {
  Material material = mirror();
  material.dfr.emplace();
  material.dfr->rgb = {DfrCurve{1, 1, 1}, DfrCurve{0.5, 0.5, 1}, DfrCurve{0.2, 0.2, 1}};
  const World world = half_plane(material, 0.0013);
  const auto scene = make_render_scene(World(world));
  const Film film = test::render_picture(*scene, from_above(), settings_of(Method::asos)).film;
  const double pixel = 2.0 * std::tan(0.5 * fov) / side;
  for (int c = 0; c < 3; ++c) {
    const Edge edge{0.0013, pixel * (1.0 / material.dfr->rgb[static_cast<std::size_t>(c)].min - 1)};
    for (int x = 0; x < side; ++x) {
      const float got = film.radiance[film.index(x, side / 2)][c] / sky_radiance;
      EXPECT_NEAR(static_cast<double>(got), 1.0 - edge.covered(x), 1e-3) << c << " " << x;
    }
  }
}

// A light's highlight is its blurred reflection: the fraction of the lobe that the light covers.
TEST(BlurredMirror, ShowsLightsWithoutGeometry) {
  Material material = mirror();
  blur(material, 0.1);
  World world = half_plane(material, -8.0);
  const Light light =
      test::make_panel({0.1, height - 1.0, 0.0}, {0, -1, 0}, {0.02, 0, 0}, {0, 0, 3}, 5.0f);
  const auto scene = make_render_scene(std::move(world), {light});
  const Film film = test::render_picture(*scene, from_above(), settings_of(Method::asos)).film;
  const double pixel = 2.0 * std::tan(0.5 * fov) / side;
  const double sky = static_cast<double>(sky_radiance), up = height - 1.0;
  for (int x = 0; x < side; ++x) {
    const double middle = (x + 0.5 - 0.5 * side) * pixel * (distance + up);
    const double own = pixel * (distance + up), lobe = 9.0 * pixel * up;
    const double share = below(0.12 - middle, own, lobe) - below(0.08 - middle, own, lobe);
    const auto got = static_cast<double>(film.radiance[film.index(x, side / 2)].x);
    EXPECT_NEAR(got, sky + share * (5.0 - sky), 5e-3) << x;
  }
}

}  // namespace
}  // namespace asos::blurred_mirror_test
