#include "renderer/shading/sky.h"
#include "tests/support/exposed_picture.h"
#include "tests/support/make_settings.h"
#include "tests/support/picture_difference.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

// Motion blur: pictures of unlit cards that move, against closed forms and many samples.

namespace asos::test::motion_test {
namespace {

constexpr int side = 16;
constexpr double pixel = 0.04;  ///< width of a pixel at the cards' depth, 4
constexpr double clip_seconds = 2.0;

/// Looks along -z from the origin.
Camera still_camera() {
  return {.fov_y_rad = 2.0 * std::atan(0.5 * side * pixel / 4.0)};
}

RenderSettings settings_of(Method method, double shutter) {
  RenderSettings settings = make_settings(side, side, method, 4096);
  settings.asos.max_level = 3;
  settings.asos.eps = 1e-4;
  settings.shutter.seconds = shutter;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

/// Adds a white card of |y| <= `half_height` at depth 4, in pixels from the picture's left edge.
void add_card(Scene& scene, double left, double right, double half_height) {
  if (scene.materials.empty()) {
    scene.materials.emplace_back();
    scene.materials[0].unlit = scene.materials[0].double_sided = true;
  }
  const auto at = [&](double x, double y) {
    return glm::vec3((x - 0.5 * side) * pixel, y * pixel, -4.0);
  };
  Mesh mesh{.positions = {at(left, -half_height), at(right, -half_height), at(right, half_height),
                          at(left, half_height)}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material = 0;
  scene.instances.push_back({"card", static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
  scene.meshes.push_back(std::move(mesh));
}

/// A pole of `width` pixels, whose left edge is at `from` at 0 s and moves by `speed` pixels a
/// second.
std::shared_ptr<PosedBy> moving_pole(double width, double from, double speed) {
  Scene scene{.source = "pole"};
  add_card(scene, from, from + width, 40.0);
  return std::make_shared<PosedBy>(scene, clip_seconds, [speed](double seconds, Scene& posed) {
    posed.instances[0].world_from_mesh =
        glm::translate(glm::dmat4(1.0), {speed * seconds * pixel, 0.0, 0.0});
  });
}

/// Integral of the covered length of the unit interval left of s, from minus infinity to s.
double covered_integral(double s) {
  if (s <= 0.0) return 0.0;
  return s < 1.0 ? 0.5 * s * s : s - 0.5;
}

/// Mean over time of the coverage of pixel `i` by a pole whose left edge moves from `a` to `b`.
double mean_coverage(int i, double width, double a, double b) {
  const auto mean = [&](double offset) {
    return (covered_integral(b + offset - i) - covered_integral(a + offset - i)) / (b - a);
  };
  return mean(width) - mean(0.0);
}

double worst_error(const Picture& picture, const std::vector<double>& expected) {
  double worst = 0.0;
  for (int x = 0; x < side; ++x) {
    const auto i = picture.film.index(x, side / 2);
    const auto found = static_cast<double>(picture.film.radiance[i].x);
    worst = std::max(worst, std::abs(found - expected[static_cast<std::size_t>(x)]));
  }
  return worst;
}

std::vector<double> blurred_pole(double width, double a, double b) {
  std::vector<double> row;
  for (int i = 0; i < side; ++i) row.push_back(mean_coverage(i, width, a, b));
  return row;
}

struct Pole {
  double width, way;
};

class MovingPole : public testing::TestWithParam<Pole> {};

TEST_P(MovingPole, IsTheBoxInTimeByAsos) {
  const auto [width, way] = GetParam();
  const auto rig = moving_pole(width, 4.2, way);
  const RenderSettings settings = settings_of(Method::asos, 1.0);
  const ExposedScene scene = exposed_at(*rig, 1.0, still_camera(), settings);
  ASSERT_TRUE(scene.exposure().moves());
  const Picture picture = render_exposed(scene, settings);
  // The shutter is open from 0.5 s to 1.5 s.
  const double a = 4.2 + 0.5 * way;
  EXPECT_LT(worst_error(picture, blurred_pole(width, a, a + way)), 1e-3)
      << scene.exposure().steps() << " steps";
}

INSTANTIATE_TEST_SUITE_P(Ways, MovingPole,
                         testing::Values(Pole{0.4, 6.3}, Pole{2.5, 1.2}, Pole{0.3, 0.3},
                                         Pole{1.0, 4.0}));

TEST(MotionBlur, SamplersAgreeWithTheBoxInTime) {
  const auto rig = moving_pole(0.7, 4.2, 5.0);
  // For `grid`: strata of time and of the pixel are paired at random, with a standard error of
  // 0.011.
  constexpr double sobol = 6e-3, grid = 0.04;
  for (const auto& [method, tolerance] :
       {std::pair{Method::sobol, sobol}, std::pair{Method::sobol_adaptive, sobol},
        std::pair{Method::mitchell, sobol}, std::pair{Method::stochastic, grid},
        std::pair{Method::ray_bound, grid}}) {
    RenderSettings settings = settings_of(method, 1.0);
    settings.asos.max_level = 4;
    settings.sampling.spp = 1024;
    settings.sampling.contrast_scale = 0.0;
    const ExposedScene scene = exposed_at(*rig, 1.0, still_camera(), settings);
    const Picture picture = render_exposed(scene, settings);
    EXPECT_LT(worst_error(picture, blurred_pole(0.7, 6.7, 11.7)), tolerance) << row_of(method).name;
  }
}

// The white pole before black covers as much as it brightens. Nothing is behind it.
TEST(MotionBlur, LayersAreMeansOverTheShutter) {
  const auto rig = moving_pole(2.3, 4.2, 3.0);
  for (const Method method : {Method::asos, Method::sobol}) {
    RenderSettings settings = settings_of(method, 1.0);
    settings.sampling.spp = 64;
    settings.layers = {Layer::alpha, Layer::object, Layer::depth, Layer::emission};
    const ExposedScene scene = exposed_at(*rig, 1.0, still_camera(), settings);
    const Film film = render_exposed(scene, settings).film;
    ASSERT_EQ(film.layers.size(), 4u) << "nothing that nobody asked for";
    std::size_t parts = 0;
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      const float white = film.radiance[i].x;
      EXPECT_NEAR(find_plane(film.layers, Layer::alpha)->at(i)[0], white, 1e-5f);
      EXPECT_NEAR(find_plane(film.layers, Layer::emission)->at(i)[2], white, 1e-5f);
      const IdShares& ids = find_plane(film.layers, Layer::object)->ids[i];
      float sum = 0.0f;
      for (const IdShare& share : ids) {
        EXPECT_TRUE(share.id != 0 || std::abs(share.share - white) < 1e-5f);
        sum += share.share;
      }
      EXPECT_NEAR(sum, 1.0f, 1e-5f);
      const float depth = find_plane(film.layers, Layer::depth)->at(i)[0];
      if (white > 0.0f)
        EXPECT_NEAR(depth, 4.0f, 1e-4f);
      else
        EXPECT_TRUE(std::isinf(depth));
      parts += white > 0.0f && white < 1.0f;
    }
    EXPECT_GT(parts, 4u * side) << "it is blurred";
    RenderSettings without = settings;
    without.layers = {};
    EXPECT_EQ(render_exposed(scene, without).film.radiance, film.radiance);
    without.background.kind = BackgroundKind::transparent;
    const Film clear = render_exposed(scene, without).film;
    EXPECT_EQ(clear.coverage, find_plane(film.layers, Layer::alpha)->values);
  }
}

TEST(MotionBlur, FollowsAnAnimatedCamera) {
  Scene still{.source = "pole"};
  add_card(still, 8.0, 8.6, 40.0);
  still.cameras = {still_camera()};
  const auto rig = std::make_shared<PosedBy>(still, clip_seconds, [](double seconds, Scene& posed) {
    posed.cameras[0].world_from_camera =
        glm::translate(glm::dmat4(1.0), {3.0 * seconds * pixel, 0.0, 0.0});
  });
  RenderSettings settings = settings_of(Method::asos, 0.5);
  settings.shutter.camera = 0;
  Camera camera = still_camera();
  camera.world_from_camera = glm::translate(glm::dmat4(1.0), {3.0 * pixel, 0.0, 0.0});
  const ExposedScene scene = exposed_at(*rig, 1.0, camera, settings);
  ASSERT_TRUE(scene.exposure().moves());
  const Picture picture = render_exposed(scene, settings);
  EXPECT_LT(worst_error(picture, blurred_pole(0.6, 8.0 - 3.0 * 1.25, 8.0 - 3.0 * 0.75)), 1e-3);
  // A camera that is not animated stands still.
  settings.shutter.camera = -1;
  const ExposedScene own = exposed_at(*rig, 1.0, camera, settings);
  const Picture sharp = render_exposed(own, settings);
  std::vector<double> expected(side, 0.0);
  expected[5] = 0.6;
  EXPECT_LT(worst_error(sharp, expected), 1e-4);
}

TEST(MotionBlur, HoldsTheFirstPoseBeforeTheClip) {
  const auto rig = moving_pole(0.5, 4.0, 8.0);
  const RenderSettings settings = settings_of(Method::asos, 1.0);
  const ExposedScene scene = exposed_at(*rig, 0.0, still_camera(), settings);
  EXPECT_TRUE(scene.exposure().before_clip);
  EXPECT_FALSE(scene.exposure().after_clip);
  const Picture picture = render_exposed(scene, settings);
  std::vector<double> expected = blurred_pole(0.5, 4.0, 8.0);
  for (double& value : expected) value *= 0.5;
  expected[4] += 0.5 * 0.5;
  EXPECT_LT(worst_error(picture, expected), 1e-3);
  EXPECT_TRUE(exposed_at(*rig, 2.0, still_camera(), settings).exposure().after_clip);
}

TEST(MotionBlur, IsTheStillPictureWhereNothingMoves) {
  const auto still = moving_pole(0.7, 4.2, 0.0);
  const auto corner = [] {
    Scene scene{.source = "corner"};
    add_card(scene, 3.3, 4.7, 3.0);
    add_card(scene, 12.3, 12.7, 40.0);
    return std::make_shared<PosedBy>(scene, clip_seconds, [](double seconds, Scene& posed) {
      posed.instances[1].world_from_mesh =
          glm::translate(glm::dmat4(1.0), {seconds * pixel, 0.0, 0.0});
    });
  }();
  for (const Method method : {Method::asos, Method::asos_published, Method::sobol}) {
    RenderSettings settings = settings_of(method, 1.0);
    settings.sampling.spp = 256;
    const ExposedScene scene = exposed_at(*still, 1.0, still_camera(), settings);
    EXPECT_FALSE(scene.exposure().moves());
    EXPECT_EQ(render_exposed(scene, settings).film.radiance,
              render_still(scene, settings).film.radiance);
    // Nothing crosses the first block; a card moves in its neighbour.
    const ExposedScene other = exposed_at(*corner, 1.0, still_camera(), settings);
    ASSERT_TRUE(other.exposure().moves());
    const Picture moving = render_exposed(other, settings);
    const Picture sharp = render_still(other, settings);
    const auto at = moving.film.index(4, 5);
    if (method == Method::sobol) {
      EXPECT_NEAR(moving.film.radiance[at].x, sharp.film.radiance[at].x, 1e-3);
    } else {
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
          EXPECT_EQ(moving.film.radiance[moving.film.index(x, y)],
                    sharp.film.radiance[sharp.film.index(x, y)]);
    }
    EXPECT_NE(moving.film.radiance[moving.film.index(13, 5)],
              sharp.film.radiance[sharp.film.index(13, 5)]);
  }
}

TEST(MotionBlur, AsPublishedElongatesPixelsOfMovingSurfaces) {
  // A card from pixel 5 to pixel 11 in the middle of a way of 4 pixels.
  const auto rig = moving_pole(6.0, 1.0, 4.0);
  RenderSettings settings = settings_of(Method::asos_published, 1.0);
  settings.asos.max_level = 5;
  const ExposedScene scene = exposed_at(*rig, 1.0, still_camera(), settings);
  const Picture picture = render_exposed(scene, settings);
  // Pixels with their centre on the card are 5 pixels long; others stay sharp.
  std::vector<double> expected(side, 0.0);
  for (int x = 5; x < 11; ++x)
    expected[static_cast<std::size_t>(x)] = (std::min(x + 3, 11) - std::max(x - 2, 5)) / 5.0;
  EXPECT_LT(worst_error(picture, expected), 0.02);
}

TEST(MotionBlur, AsPublishedShowsAllDepthsBetweenTheCamerasPlanes) {
  // A white card at depth 4 before a grey wall at depth 12, which both move.
  Scene scene{.source = "card"};
  add_card(scene, 1.0, 7.0, 40.0);
  add_card(scene, -80.0, 96.0, 40.0);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].base_color = glm::vec4(0.25f, 0.25f, 0.25f, 1.0f);
  scene.meshes[1].material = 1;
  const auto rig = std::make_shared<PosedBy>(scene, clip_seconds, [](double seconds, Scene& posed) {
    const glm::dvec3 way(4.0 * seconds * pixel, 0.0, 0.0);
    posed.instances[0].world_from_mesh = glm::translate(glm::dmat4(1.0), way);
    posed.instances[1].world_from_mesh =
        glm::translate(glm::dmat4(1.0), way + glm::dvec3(0.0, 0.0, 8.0));
  });
  // Looks along z, from behind the origin between both.
  Camera camera = still_camera();
  camera.world_from_camera = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -8)),
                                         std::numbers::pi, glm::dvec3(0, 1, 0));
  const RenderSettings settings = settings_of(Method::asos_published, 1.0);
  const auto middle = [&] {
    const Picture picture = render_exposed(exposed_at(*rig, 1.0, camera, settings), settings);
    return picture.film.radiance[picture.film.index(8, side / 2)].x;
  };
  EXPECT_NEAR(middle(), 1.0, 1e-3);
  camera.near_depth = 5.0;
  EXPECT_NEAR(middle(), 0.25, 1e-3);
  camera.near_depth.reset();
  camera.far_depth = 3.0;
  EXPECT_NEAR(middle(), 0.0, 1e-3);
}

TEST(MotionBlur, IsTheCauseOfPixelsThatItChanges) {
  // From pixel 5 to pixel 11, and by 2 pixels to either side.
  const auto rig = moving_pole(6.0, 1.0, 4.0);
  for (const Method method : {Method::asos, Method::asos_published}) {
    const RenderSettings settings = settings_of(method, 1.0);
    const Picture picture =
        render_exposed(exposed_at(*rig, 1.0, still_camera(), settings), settings);
    std::uint64_t moving = 0;
    for (int x = 0; x < side; ++x) {
      const SplitCause cause = picture.film.cause[picture.film.index(x, side / 2)];
      // Pixels with their centre on the moving card are elongated as published.
      const bool changes =
          method == Method::asos ? (x >= 3 && x < 7) || (x >= 9 && x < 13) : x >= 5 && x < 11;
      EXPECT_EQ(cause == SplitCause::motion, changes) << row_of(method).name << ", " << x;
    }
    for (const SplitCause cause : picture.film.cause) moving += cause == SplitCause::motion;
    const RenderStatistics& counts = picture.statistics;
    EXPECT_EQ(counts.pixels_by_cause[static_cast<std::size_t>(SplitCause::motion)], moving);
    EXPECT_GE(counts.split_pixels, moving);
  }
}

/// Mean over the pixel and over the angles of a turning wheel of two spokes. Independent of the
/// renderer: R2 points in three dimensions (Roberts 2018), each with an angle of its own.
double turned_wheel(int px, int py, double first_angle, double last_angle) {
  constexpr int samples = 65536;
  // The root of x^4 = x + 1.
  constexpr double phi = 1.2207440846057596;
  int met = 0;
  for (int i = 1; i <= samples; ++i) {
    double p[3];
    for (int k = 0; k < 3; ++k) {
      const double at = 0.5 + i * std::pow(phi, -(k + 1));
      p[k] = at - std::floor(at);
    }
    const double angle = first_angle + p[2] * (last_angle - first_angle);
    const double x = px + p[0] - 0.5 * side, y = 0.5 * side - py - p[1];
    const double u = std::abs(std::cos(angle) * x + std::sin(angle) * y);
    const double v = std::abs(std::cos(angle) * y - std::sin(angle) * x);
    met += (u < 5.5 && v < 0.45) || (u < 0.4 && v < 5.5);
  }
  return static_cast<double>(met) / samples;
}

TEST(MotionBlur, OfATurningWheelAgreesWithContinuousTime) {
  Scene scene{.source = "wheel"};
  add_card(scene, 2.5, 13.5, 0.45);
  add_card(scene, 7.6, 8.4, 5.5);
  constexpr double speed = 0.8;  // radians a second
  const auto rig = std::make_shared<PosedBy>(scene, clip_seconds, [](double seconds, Scene& posed) {
    for (Instance& spoke : posed.instances)
      spoke.world_from_mesh = glm::rotate(glm::dmat4(1.0), speed * seconds, glm::dvec3(0, 0, 1));
  });
  RenderSettings settings = settings_of(Method::asos, 1.0);
  settings.asos.eps = 1e-3;
  const ExposedScene wheel = exposed_at(*rig, 1.0, still_camera(), settings);
  const Picture exact = render_exposed(wheel, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 2048;
  const Picture sampled = render_exposed(wheel, settings);
  double squares = 0.0;
  int pixels = 0;
  // A wheel of two spokes is the same after half a turn.
  for (int y = 2; y < side / 2; ++y) {
    for (int x = 2; x < side - 2; ++x, ++pixels) {
      const glm::vec3 found = exact.film.radiance[exact.film.index(x, y)];
      const double error =
          static_cast<double>(found.x) - turned_wheel(x, y, 0.5 * speed, 1.5 * speed);
      squares += error * error;
    }
  }
  EXPECT_LT(std::sqrt(squares / pixels), 5e-4);
  EXPECT_LT(difference(exact, sampled).rmse, 1.5e-3);
  EXPECT_GT(difference(sampled, render_still(wheel, settings)).rmse, 0.05) << "blurred";
}

TEST(MotionBlur, TakesAsManyStepsAsTheWayNeeds) {
  const auto steps = [](double way) {
    const auto rig = moving_pole(1.0, 8.0 - way, way);
    const RenderSettings settings = settings_of(Method::asos, 1.0);
    return exposed_at(*rig, 1.0, still_camera(), settings).scene->exposure;
  };
  EXPECT_EQ(steps(0.01)->steps(), 4);
  EXPECT_EQ(steps(0.9)->steps(), 16);
  EXPECT_FALSE(steps(0.9)->limited);
  EXPECT_NEAR(steps(0.9)->step_pixels, 0.9 / 16.0, 1e-5);
  const auto fast = steps(-15.0);
  EXPECT_EQ(fast->steps(), 64);
  const auto faster = steps(200.0);
  EXPECT_EQ(faster->steps(), 256) << "a pixel a step";
  EXPECT_FALSE(faster->limited);
  const auto fastest = steps(6000.0);
  EXPECT_EQ(fastest->steps(), Exposure::most_steps);
  EXPECT_TRUE(fastest->limited);
  EXPECT_EQ(exposure_remarks(*fastest).size(), 1u);
}

TEST(MotionBlur, IsLeftOutByMethodsOfOneMoment) {
  const auto rig = moving_pole(0.7, 4.2, 4.0);
  for (const Method method : {Method::beam, Method::cone, Method::covers, Method::mask}) {
    const RenderSettings settings = settings_of(method, 1.0);
    const ExposedScene scene = exposed_at(*rig, 1.0, still_camera(), settings);
    EXPECT_FALSE(moving_picture(*scene.scene, scene.camera, settings));
    EXPECT_FALSE(row_of(method).takes_motion);
  }
}

TEST(MotionBlur, FollowsAMovingLightAndItsShadow) {
  Scene scene{.source = "light"};
  add_card(scene, -40.0, 56.0, 40.0);
  scene.materials[0].unlit = false;
  Light light{.type = Light::Type::directional, .intensity = 1.0f};
  scene.lights = {light};
  const auto rig = std::make_shared<PosedBy>(scene, clip_seconds, [](double seconds, Scene& posed) {
    posed.lights[0].intensity = static_cast<float>(seconds);
  });
  RenderSettings settings = settings_of(Method::asos, 1.0);
  const ExposedScene lit = exposed_at(*rig, 0.5, still_camera(), settings);
  ASSERT_TRUE(lit.exposure().moves());
  const Picture blurred = render_exposed(lit, settings);
  const Picture middle = render_still(lit, settings);
  // The light is linear in time: its mean is that at the middle.
  EXPECT_GT(middle.film.radiance[0].x, 0.01f);
  EXPECT_LT(difference(blurred, middle).largest, 1e-4);
}

}  // namespace
}  // namespace asos::test::motion_test
