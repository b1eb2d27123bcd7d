#include "renderer/geometry/lens.h"

#include "renderer/geometry/validate_camera.h"
#include "renderer/geometry/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

// A thin lens: aperture, rays and circles of confusion, against closed forms.

namespace asos::test::lens_test {
namespace {

using std::numbers::pi;

constexpr int grid = 256;

/// Calls visit(point) for a grid of points that contains the aperture.
template <typename Visit>
void for_each_point(const Lens& lens, Visit&& visit) {
  for (int i = 0; i < grid * grid; ++i)
    visit(point_on_aperture(lens, {(i % grid + 0.5) / grid, (i / grid + 0.5) / grid}));
}

Lens aperture(int blades, double turn_rad = 0.0) {
  return {.radius = 2.0, .blades = blades, .turn_rad = turn_rad};
}

/// Whether a point is in the scaled polygon of `aperture`. Uses the distances from the sides.
bool in_polygon(const Lens& lens, glm::dvec2 p, double scale) {
  const double step = 2.0 * pi / lens.blades;
  for (int k = 0; k < lens.blades; ++k) {
    const double middle = lens.turn_rad + (k + 0.5) * step;
    const double distance = p.x * std::cos(middle) + p.y * std::sin(middle);
    if (distance > scale * lens.radius * std::cos(0.5 * step) + 1e-12) return false;
  }
  return true;
}

TEST(Aperture, DiskHasEqualAreas) {
  int inner = 0, right = 0, diagonal = 0;
  for_each_point(aperture(0), [&](glm::dvec2 p) {
    EXPECT_LE(glm::length(p), 2.0 + 1e-12);
    inner += glm::length(p) < 1.0;
    right += p.x > 0.0;
    diagonal += p.x + p.y > 0.0;
  });
  constexpr double all = grid * grid;
  EXPECT_NEAR(inner / all, 0.25, 2e-3);
  EXPECT_NEAR(right / all, 0.5, 2e-3);
  EXPECT_NEAR(diagonal / all, 0.5, 5e-3);
}

TEST(Aperture, PolygonHasEqualAreas) {
  for (const int blades : {3, 4, 5, 6, 9}) {
    const Lens lens = aperture(blades, 0.3);
    int inner = 0;
    std::vector<int> sectors(static_cast<std::size_t>(blades), 0);
    for_each_point(lens, [&](glm::dvec2 p) {
      EXPECT_TRUE(in_polygon(lens, p, 1.0)) << blades;
      inner += in_polygon(lens, p, 0.5);
      const double angle = std::atan2(p.y, p.x) - lens.turn_rad;
      const double turns = angle / (2.0 * pi) - std::floor(angle / (2.0 * pi));
      ++sectors[std::min(static_cast<std::size_t>(turns * blades), sectors.size() - 1)];
    });
    constexpr double all = grid * grid;
    EXPECT_NEAR(inner / all, 0.25, 3e-3) << blades;
    for (const int sector : sectors) EXPECT_NEAR(sector / all, 1.0 / blades, 3e-3) << blades;
  }
}

TEST(Aperture, MomentsAreThoseOfItsPoints) {
  for (const int blades : {0, 3, 4, 7}) {
    const Lens lens = aperture(blades);
    glm::dvec2 sum(0.0), squares(0.0);
    for_each_point(lens, [&](glm::dvec2 p) { sum += p, squares += p * p; });
    constexpr double all = grid * grid;
    EXPECT_NEAR(glm::length(sum) / all, 0.0, 1e-2) << blades;
    for (const int axis : {0, 1})
      EXPECT_NEAR(squares[axis] / all, 4.0 * aperture_variance(lens), 1e-2) << blades;
  }
  EXPECT_NEAR(aperture_share(aperture(4)), 2.0 / pi, 1e-12);
  EXPECT_EQ(aperture_share(aperture(0)), 1.0);
}

TEST(FStop, IsOfASensor24Millimetres) {
  // A focal length of 50 mm at f/2 has an aperture of 25 mm.
  const double fov = 2.0 * std::atan(0.012 / 0.050);
  EXPECT_NEAR(aperture_of_f_stop(2.0, fov), 0.0125, 1e-12);
  EXPECT_NEAR(f_stop_of_aperture(0.0125, fov), 2.0, 1e-12);
}

Camera camera_with_lens() {
  Camera camera{.fov_y_rad = 0.5 * pi};
  camera.world_from_camera[3] = glm::dvec4(1, 2, 3, 1);
  camera.lens.radius = 0.5;
  camera.lens.focus = 4.0;
  return camera;
}

TEST(LensView, RaysMeetOnTheFocusPlane) {
  const View view(camera_with_lens(), 16, 16);
  ASSERT_TRUE(view.has_lens());
  const Ray middle = view.ray(3.0, 13.0);
  const glm::vec3 sharp = middle.at(4.0f / -middle.direction.z);
  for (const glm::dvec2 lens : {glm::dvec2(0.5, 0), {0, 0.5}, {-0.3, -0.4}}) {
    const Ray ray = view.ray(3.0, 13.0, {lens});
    EXPECT_LT(glm::length(ray.origin - glm::vec3(1 + lens.x, 2 + lens.y, 3)), 1e-6f);
    EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
    EXPECT_LT(glm::length(ray.at(4.0f / -ray.direction.z) - sharp), 1e-5f);
    EXPECT_NEAR(view.depth(ray, 4.0f / -ray.direction.z), 4.0, 1e-5);
  }
}

TEST(LensView, RaysOfNearFocusCrossTheAxisAtOnce) {
  for (const double focus : {1e-6, 1e-30, 1e-300}) {
    Camera camera = camera_with_lens();
    camera.lens.focus = focus;
    const Ray ray = View(camera, 16, 16).ray(8.0, 8.0, {glm::dvec2(0.5, 0)});
    EXPECT_NEAR(ray.direction.x, -1.0f, 1e-5f) << focus;
    EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f) << focus;
  }
}

TEST(LensView, ConfusionIsLinearInInverseDepth) {
  const View view(camera_with_lens(), 16, 16);
  // A pixel is 1/8 wide at distance 1.
  EXPECT_EQ(view.confusion(4.0), 0.0);
  EXPECT_NEAR(view.confusion(2.0), 0.5 / 0.125 * 0.25, 1e-12);
  EXPECT_NEAR(view.confusion(std::numeric_limits<double>::infinity()), 0.5 / 0.125 * 0.25, 1e-12);
  EXPECT_NEAR(view.confusion(view.depth_before_focus(3.0)), 3.0, 1e-12);
  EXPECT_LT(view.depth_before_focus(3.0), 4.0);
}

TEST(LensView, PlanesCutRaysAtTheirDepths) {
  Camera camera = camera_with_lens();
  camera.near_depth = 1.5;
  camera.far_depth = 6.0;
  const View view(camera, 16, 16, 100.0);
  const Ray ray = view.ray(2.0, 5.0, {{0.3, -0.2}});
  EXPECT_NEAR(view.depth(ray, ray.t_near), 1.5, 1e-5);
  EXPECT_NEAR(view.depth(ray, ray.t_far), 6.0, 1e-5);
}

TEST(LensView, NoLensWithoutFocusOrPerspective) {
  Camera camera = camera_with_lens();
  camera.lens.focus.reset();
  EXPECT_FALSE(View(camera, 16, 16).has_lens());
  camera = camera_with_lens();
  camera.type = Camera::Type::orthographic;
  EXPECT_FALSE(View(camera, 16, 16).has_lens());
  camera = camera_with_lens();
  camera.lens.radius = 0.0;
  EXPECT_FALSE(View(camera, 16, 16).has_lens());
}

TEST(LensFault, NamesWhatIsOutOfRange) {
  const auto fault_of = [](auto change) {
    Camera camera = camera_with_lens();
    change(camera);
    return validate_camera(camera);
  };
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault_of([](Camera&) {}), "");
  for (const double radius : {-1.0, infinite, nan, 1e300})
    EXPECT_NE(fault_of([&](Camera& c) { c.lens.radius = radius; }).find("radius"),
              std::string::npos);
  for (const double focus : {-1.0, 0.0, infinite, nan})
    EXPECT_NE(fault_of([&](Camera& c) { c.lens.focus = focus; }).find("focus"), std::string::npos);
  for (const int blades : {-1, 1, 2, 33})
    EXPECT_NE(fault_of([&](Camera& c) { c.lens.blades = blades; }).find("blades"),
              std::string::npos);
  EXPECT_NE(fault_of([](Camera& c) { c.lens.turn_rad = 7.0; }).find("turn"), std::string::npos);
  EXPECT_NE(fault_of([](Camera& c) { c.type = Camera::Type::orthographic; }).find("perspective"),
            std::string::npos);
}

}  // namespace
}  // namespace asos::test::lens_test
