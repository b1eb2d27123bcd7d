#include "renderer/comparison/method.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos::plane_mirror_test {
namespace {

using test::add_quad;
using test::add_sphere;
using test::add_triangle;
using test::look_at;
using test::make_render_scene;
using test::unlit;

constexpr int width = 48;
constexpr int height = 40;

Material mirror(double dfr = 1.0) {
  Material m{
      .base_color = glm::vec4(1.0f), .metallic = 1.0f, .roughness = 0.0f, .double_sided = true};
  if (dfr < 1.0) {
    m.dfr.emplace();
    m.dfr->rgb.fill({dfr, dfr, 1.0});
  }
  return m;
}

/// Two triangles and a sliver in front of the plane x + 0.3 z = 0, behind the camera; or their
/// mirror images.
World things(bool mirrored) {
  const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 0.0f, 0.3f));
  const auto place = [&](glm::vec3 p) {
    p.x += 2.0f;
    return mirrored ? p - 2.0f * glm::dot(p, n) * n : p;
  };
  World world;
  const auto triangle = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 colour) {
    Material m = unlit(colour);
    m.double_sided = true;
    add_triangle(world, place(a), place(b), place(c), m);
  };
  triangle({1, -1, -2}, {2.2f, 1.3f, -1}, {1.4f, 1, 1.5f}, {0.9f, 0.2f, 0.1f});
  triangle({3, -2, -3}, {3, 2, -3}, {3, 0.2f, 3}, {0.1f, 0.3f, 0.9f});
  triangle({2, -0.3f, -3}, {2, -0.25f, 3}, {2.01f, -0.2f, 3}, {0.2f, 0.9f, 0.3f});
  return world;
}

// Objects in a mirror that fills the picture, or mirrored objects.
std::vector<glm::vec3> picture(bool by_mirror, const Material& material) {
  World world = things(!by_mirror);
  const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 0.0f, 0.3f));
  const glm::vec3 along(-n.z, 0, n.x);
  if (by_mirror)
    add_quad(world, -40.0f * along - glm::vec3(0, 40, 0), 80.0f * along, {0, 80, 0}, material);
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = test::make_settings(width, height);
  settings.asos.eps = 0.0;
  const Camera camera = look_at({2, 0.3, 0.5}, {0, 0, 0.2}, 1.2);
  return test::render_picture(*scene, camera, settings).film.radiance;
}

double worst_difference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::vec3 off = glm::abs(a[i] - b[i]);
    worst = std::max(worst, static_cast<double>(std::max({off.x, off.y, off.z})));
  }
  return worst;
}

TEST(PlaneMirror, ShowsTheMirroredScene) {
  const auto seen = picture(true, mirror());
  const auto direct = picture(false, mirror());
  ASSERT_EQ(seen.size(), direct.size());
  EXPECT_LT(worst_difference(seen, direct), 1e-5);
}

/// A wall of 4 mm on a mirror of four kilometres, whose rounding is larger than the wall; or,
/// without the mirror, a wall that extends as far below.
std::vector<glm::vec3> low_wall(bool by_mirror, Method method) {
  World world;
  Material red = unlit({0.9f, 0.2f, 0.1f});
  red.double_sided = true;
  const float foot = by_mirror ? 0.0f : -0.004f;
  add_quad(world, {-0.02f, foot, 0}, {0.03f, 0, 0}, {0, 0.004f - foot, 0}, red);
  if (by_mirror) add_quad(world, {-2000, 0, 2000}, {4000, 0, 0}, {0, 0, -4000}, mirror());
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = test::make_settings(width, height, method);
  settings.asos.eps = 0.0;
  const Camera camera = look_at({0.003, 0.02, 0.06}, {0.0, 0.0, 0.0}, 0.4);
  return test::render_picture(*scene, camera, settings).film.radiance;
}

TEST(PlaneMirror, ShowsObjectsDownToTheirFoot) {
  EXPECT_LT(worst_difference(low_wall(true, Method::asos), low_wall(false, Method::asos)), 2e-3);
  // Both pictures use the same samples.
  const auto seen = low_wall(true, Method::sobol), direct = low_wall(false, Method::sobol);
  int differ = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    differ += glm::length(seen[i] - direct[i]) > 0.1f ? 1 : 0;
  EXPECT_LE(differ, 2) << "pixels with two samples on the other side of an edge";
}

/// The reflected objects behind a grating of thin bars; each gap is a leaf.
std::vector<glm::vec3> behind_bars(double eps) {
  World world = things(false);
  const glm::vec3 n = glm::normalize(glm::vec3(1.0f, 0.0f, 0.3f));
  const glm::vec3 along(-n.z, 0, n.x);
  add_quad(world, -40.0f * along - glm::vec3(0, 40, 0), 80.0f * along, {0, 80, 0}, mirror());
  Material grey = unlit(glm::vec3(0.4f));
  grey.double_sided = true;
  for (int i = 0; i < 120; ++i) {
    const glm::vec3 foot = 0.5f * n + (0.025f * static_cast<float>(i) - 1.5f) * along;
    add_quad(world, foot - glm::vec3(0, 2, 0), 0.006f * along, {0.1f * n.x, 4, 0}, grey);
  }
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = test::make_settings(width, height);
  settings.asos.eps = eps;
  return test::render_picture(*scene, look_at({2, 0.3, 0.5}, {0, 0, 0.2}, 1.2), settings)
      .film.radiance;
}

// Each leaf's reflection has a fraction of EPS as its tolerance: a pixel's standard error is at
// most half of EPS.
TEST(PlaneMirror, ManyReflectedLeavesStayWithinEps) {
  const auto found = behind_bars(0.125), exact = behind_bars(0.0);
  double squares = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 off(found[i] - exact[i]);
    squares += glm::dot(off, off) / 3.0;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(found.size())), 0.25 * 0.125);
  EXPECT_LT(worst_difference(found, exact), 2.0 * 0.125);
}

}  // namespace
}  // namespace asos::plane_mirror_test
