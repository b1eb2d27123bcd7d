#include "renderer/shading/dfr.h"
#include "tests/renderer/asos/glass_world.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// What is left of light within volumes of glass, closed or not (Beer's and Lambert's law), and what
// bends none.

namespace asos::test::glass {
namespace {

TEST(GlassVolume, AttenuatesByTheWayThroughIt) {
  constexpr double n = 1.5, thickness = 0.4;
  Material green = clear(static_cast<float>(n));
  green.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  green.volume.attenuation_distance = 0.5f;
  for (const double i : {0.0, 0.8}) {
    const double way = thickness / std::cos(std::asin(std::sin(i) / n));
    World world;
    add_plate(world, i, thickness, green);
    add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
      EXPECT_NEAR(seen.x, std::pow(0.25, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.y, std::pow(0.9, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.z, 0.0, 1e-3);
    }
  }
}

TEST(GlassVolume, AddsNoLight) {
  Material glass = clear(1.5f);
  glass.specular = 1.0f;
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  // Faint rays end by chance, which is noise within EPS: that is to be less than what is asked of
  // each pixel.
  constexpr double eps = 1.0 / 2048.0;
  for (const float roughness : {0.0f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_shape(world, sphere(1.0), glm::dmat4(1.0), glass);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen = picture(*scene, orthographic(2.2), method, white, eps);
      EXPECT_LE(mean(seen).y, 1.001) << roughness << ", method " << static_cast<int>(method);
      if (roughness > 0.0f) continue;
      for (const glm::vec3 p : seen) {
        EXPECT_LE(p.y, 1.001f) << "method " << static_cast<int>(method);
        EXPECT_GE(p.y, 0.98f) << "method " << static_cast<int>(method);
      }
    }
  }
}

// A frosted pane, too, returns what it does not let through, and no more.
TEST(GlassVolume, FrostedWallsAddNoLight) {
  Material glass = clear(1.5f);
  glass.volume.thickness = 0.0f;
  glass.specular = 1.0f;
  glass.double_sided = true;
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const float roughness : {0.1f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 2}, glass);
    add_quad(world, {-5, -5, -1}, {10, 0, 1}, {0, 10, 0}, glass);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const double seen = mean(picture(*scene, orthographic(2.0), method, white)).y;
      EXPECT_LE(seen, 1.001) << roughness << ", method " << static_cast<int>(method);
      // Lobes lose what would be reflected twice.
      EXPECT_GE(seen, 0.97) << roughness << ", method " << static_cast<int>(method);
    }
  }
}

Material green() {
  Material m = clear(1.5f);
  m.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  m.volume.attenuation_distance = 2.0f;
  return m;
}

/// What white that fills the picture looks like.
void expect_attenuated(World world, const Camera& camera, double way) {
  const auto scene = make_render_scene(std::move(world));
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const Method method : methods) {
    const glm::dvec3 seen = mean(picture(*scene, camera, method, white));
    EXPECT_NEAR(seen.x, std::pow(0.25, way / 2.0), 1e-3) << static_cast<int>(method);
    EXPECT_NEAR(seen.y, std::pow(0.9, way / 2.0), 1e-3) << static_cast<int>(method);
    EXPECT_NEAR(seen.z, way > 0.0 ? 0.0 : 1.0, 1e-3) << static_cast<int>(method);
  }
}

TEST(GlassVolume, AttenuatesFromTheEyeWhereThatIsWithin) {
  World world;
  add_plate(world, 0.0, 1.0, green());
  Camera camera = orthographic(0.5);
  camera.world_from_camera[3] = glm::dvec4(0, 0, 0.2, 1);
  expect_attenuated(std::move(world), camera, 0.7);
}

TEST(GlassVolume, AttenuatesWithinAnOpenSurfaceUpToWhatLiesBehind) {
  World world;
  add_quad(world, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, green());
  add_quad(world, {-50, -50, -2}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
  expect_attenuated(std::move(world), orthographic(0.5), 3.0);
  // Nothing does: there is no telling how thick it is.
  World open;
  add_quad(open, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, green());
  expect_attenuated(std::move(open), orthographic(0.5), 0.0);
}

TEST(GlassVolume, OfAnInfiniteIndexReflectsAll) {
  Material mirror = clear(0.0f);
  mirror.specular = 1.0f;
  World world;
  add_plate(world, 0.3, 1.0, mirror);
  add_quad(world, {-50, -50, -2}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(0.0f)));
  const auto scene = make_render_scene(std::move(world));
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const Method method : methods)
    EXPECT_NEAR(mean(picture(*scene, orthographic(0.5), method, white)).y, 1.0, 1e-3);
}

TEST(GlassVolume, ThinWallsAndUnfollowedOnesBendNothing) {
  for (const bool thin : {true, false}) {
    Material m = clear(1.5f);
    if (thin) m.volume.thickness = 0.0f;
    World world;
    add_plate(world, 1.0, 0.4, m);
    add_edge(world, 0.0123, -6.0);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      RenderSettings settings;
      settings.width = settings.height = picture_side;
      settings.method = method;
      settings.sampling.spp = 256;
      if (!thin) settings.mirror.bounces = 0;
      const auto seen = render_picture(*scene, orthographic(1.0), settings).film.radiance;
      EXPECT_NEAR(edge_in(seen, 1.0), 0.0123, 1e-3) << thin << " " << static_cast<int>(method);
    }
  }
}

/// How much of three boxes, convolved with each other, lies below x: by the sum of cubes that their
/// third-order spline is.
double below(double x, glm::dvec3 widths) {
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    double at = x;
    int minus = 0;
    for (int k = 0; k < 3; ++k) {
      const bool low = (corner >> k & 1) == 0;
      at += (low ? 0.5 : -0.5) * widths[k];
      minus += low ? 0 : 1;
    }
    sum += (minus % 2 == 0 ? 1.0 : -1.0) * std::pow(std::max(0.0, at), 3.0);
  }
  return sum / (6.0 * widths.x * widths.y * widths.z);
}

/// The steps of a ramp from 1 to 0, and how far they are spread.
struct Ramp {
  double last = 1.0, first = 0.0, second = 0.0;

  void add(double at, double value) {
    first += (last - value) * at;
    second += (last - value) * at * at;
    last = value;
  }
  [[nodiscard]] double variance() const { return second - first * first; }
};

// Each side of a rough plate turns rays by what the facet is turned, times |1 - ratio of the
// indices|: an edge behind it is a ramp, of a pixel convolved with what both sides do, whatever of
// them is the widest.
TEST(GlassVolume, RoughGlassBlursWhatLiesBehindIt) {
  constexpr double n = 1.5, thickness = 0.4, behind = 3.8, width = 2.0;
  constexpr double pixel = width / picture_side;
  for (const double roughness : {0.1, 0.2, 0.3, 0.5}) {
    World world;
    Material frosted = clear(static_cast<float>(n));
    frosted.roughness = static_cast<float>(roughness);
    add_plate(world, 0.0, thickness, frosted);
    constexpr double edge = 0.0123;
    add_edge(world, edge, -behind - 0.5 * thickness);
    const auto scene = make_render_scene(std::move(world));
    const double facets = 0.5 * lobe_width(roughness);
    const double by_first = facets * (1.0 - 1.0 / n) * (thickness + n * behind);
    const double by_second = facets * (n - 1.0) * behind;
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen = picture(*scene, orthographic(width), method);
      // Two boxes stand for three in ASOS: of the same variance, but not all of the shape. The
      // samples of a column are independent of each other.
      const bool exact = method == Method::asos;
      const double allowed = exact ? 0.01 : 3.0 * 0.5 / std::sqrt(12.0 * 256.0);
      Ramp seen_ramp, expected_ramp;
      for (int x = 0; x < picture_side; ++x) {
        double column = 0.0;
        for (int y = 0; y < picture_side; ++y)
          column += static_cast<double>(seen[static_cast<std::size_t>(y * picture_side + x)].y);
        column /= picture_side;
        const double middle = (x + 0.5 - 0.5 * picture_side) * pixel;
        const double expected = below(edge - middle, {pixel, by_first, by_second});
        EXPECT_NEAR(column, expected, allowed) << "roughness " << roughness << ", column " << x
                                               << ", method " << static_cast<int>(method);
        seen_ramp.add(middle - 0.5 * pixel, column);
        expected_ramp.add(middle - 0.5 * pixel, expected);
      }
      // One that is all in the picture, and so wide that columns tell its shape.
      if (exact && roughness == 0.3) {
        EXPECT_NEAR(seen_ramp.variance(), expected_ramp.variance(), 0.01 * expected_ramp.variance())
            << roughness;
      }
    }
  }
}

// A rough thin wall shows what lies behind it as a mirror as rough shows what lies before it, on
// the other side: straight on, convolved with the lobe (KHR_materials_transmission).
TEST(GlassVolume, RoughThinWallsBlurAsMirrorsDo) {
  constexpr double behind = 4.0, width = 2.0, pixel = width / picture_side, edge = 0.0123;
  for (const double angle : {0.0, 0.8}) {
    for (const double roughness : {0.05, 0.2, 0.4}) {
      World world;
      Material frosted = clear(1.5f);
      frosted.volume.thickness = 0.0f;
      frosted.double_sided = true;
      frosted.roughness = static_cast<float>(roughness);
      // Seen upright, and along its length at an angle.
      const auto up = static_cast<float>(std::cos(angle)),
                 back = static_cast<float>(std::sin(angle));
      add_quad(world, {-5, -5 * up, 5 * back}, {10, 0, 0}, {0, 10 * up, -10 * back}, frosted);
      add_edge(world, edge, -behind, 40.0);
      const auto scene = make_render_scene(std::move(world));
      for (const Method method : methods) {
        const std::vector<glm::vec3> seen = picture(*scene, orthographic(width), method);
        for (int x = 0; x < picture_side; ++x) {
          double column = 0.0, expected = 0.0;
          for (int y = 0; y < picture_side; ++y) {
            column += static_cast<double>(seen[static_cast<std::size_t>(y * picture_side + x)].y);
            // The wall leans towards the viewer at its lower end.
            const double up_there = (0.5 * picture_side - y - 0.5) * pixel;
            const double blur = lobe_width(roughness) * (behind - up_there * std::tan(angle));
            const double middle = (x + 0.5 - 0.5 * picture_side) * pixel;
            // A third box that is next to nothing.
            expected += below(edge - middle, {pixel, blur, 1e-3});
          }
          const double allowed =
              method == Method::asos ? 3e-3 : 3.0 * 0.5 / std::sqrt(12.0 * 256.0);
          EXPECT_NEAR(column / picture_side, expected / picture_side, allowed)
              << "roughness " << roughness << ", angle " << angle << ", column " << x << ", method "
              << static_cast<int>(method);
        }
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::glass
