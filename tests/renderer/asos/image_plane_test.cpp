#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cstddef>

// Rays of an orthographic camera start in its image plane: a surface that crosses this plane ends
// there without an edge.

namespace asos::test::image_plane_test {
namespace {

constexpr int side = 24;

/// A camera in the plane z = 0 that sees 4 x 4 units along -z.
Camera in_plane() {
  return {.type = Camera::Type::orthographic, .height = 4.0};
}

/// A slope over the whole view that crosses the plane along a line; the part above it is in front
/// of the camera.
Picture slope(glm::dvec2 line_at, glm::dvec2 up, int max_level) {
  const glm::dvec2 along(up.y, -up.x);
  const auto at = [&](double a, double b) {
    const glm::dvec2 p = line_at + a * along + b * up;
    return glm::vec3(glm::dvec3(p, -0.7 * b));
  };
  World world;
  Material material = matte(glm::vec3(0.2f));
  material.unlit = material.double_sided = true;
  add_quad(world, at(-9, -9), at(9, -9) - at(-9, -9), at(-9, 9) - at(-9, -9), material);
  RenderSettings settings = make_settings(side, side);
  settings.asos.max_level = max_level;
  return render_picture(*make_render_scene(std::move(world)), in_plane(), settings);
}

TEST(ImagePlane, CutsCrossingSurfacesExactly) {
  // The line is horizontal within row 11; the slope covers the upper 0.22 of that row.
  const double pixel = 4.0 / side;
  const Picture picture = slope({0.0, 2.0 - 11.22 * pixel}, {0.0, 1.0}, 3);
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
  for (int x = 0; x < side; ++x) {
    const auto value = [&](int y) {
      return static_cast<double>(picture.film.radiance[static_cast<std::size_t>(y * side + x)].x);
    };
    ASSERT_GT(value(12), value(10) + 0.05) << "the background must be brighter than the slope";
    EXPECT_NEAR((value(12) - value(11)) / (value(12) - value(10)), 0.22, 1e-4) << x;
    EXPECT_EQ(value(9), value(10));
  }
}

TEST(ImagePlane, CutsAlongAnyLine) {
  // A line through the picture's centre halves its area.
  const Picture picture = slope({0.0, 0.0}, glm::normalize(glm::dvec2(0.4, 1.0)), 3);
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
  const double slope_seen = static_cast<double>(picture.film.radiance.front().x);
  const double nothing = static_cast<double>(picture.film.radiance.back().x);
  double sum = 0.0;
  for (const glm::vec3& c : picture.film.radiance) sum += static_cast<double>(c.x);
  EXPECT_NEAR(sum / (side * side), 0.5 * (slope_seen + nothing), 1e-4);
}

}  // namespace
}  // namespace asos::test::image_plane_test
