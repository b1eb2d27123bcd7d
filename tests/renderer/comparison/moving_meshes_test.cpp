#include "renderer/shading/sky.h"
#include "renderer/world/placements.h"
#include "tests/support/exposed_picture.h"
#include "tests/support/make_settings.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// Motion blur of meshes of many triangles, whose moments would not fit into memory as copies, and
// of exposures with few moments. Poles slide over a black background, so that a streak has a closed
// form.

namespace asos::test::moving_meshes_test {
namespace {

constexpr double clip_seconds = 1.0;
constexpr double depth = 4.0;

struct Shot {
  int width = 32, height = 4;
  double pole = 2.3;            ///< width, in pixels
  double from = 4.2, way = 20;  ///< of its left edge, in pixels
  int columns = 1, rows = 1;    ///< of its mesh, each of two triangles
  bool bends = false;           ///< its vertices move, too, by nothing that is seen
  bool camera_moves = false;    ///< instead of the pole

  [[nodiscard]] double pixel() const { return 2.0 * depth / height; }
};

Camera camera_of(const Shot& shot) {
  return {.fov_y_rad = 2.0 * std::atan(0.5 * shot.height * shot.pixel() / depth)};
}

RenderSettings settings_of(const Shot& shot, Method method) {
  RenderSettings settings = make_settings(shot.width, shot.height, method, 1024);
  settings.asos.eps = 1e-3;
  settings.sampling.contrast_scale = 0.0;  // mitchell looks everywhere closely
  settings.shutter.seconds = clip_seconds;
  settings.shutter.camera = shot.camera_moves ? 0 : -1;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

/// A white card as high as several pictures, with its left edge at `from`.
Mesh pole_of(const Shot& shot) {
  Mesh mesh;
  for (int j = 0; j <= shot.rows; ++j) {
    for (int i = 0; i <= shot.columns; ++i) {
      const double x = shot.from + shot.pole * i / shot.columns - 0.5 * shot.width;
      const double y = shot.height * (2.0 * j / shot.rows - 1.0);
      mesh.positions.emplace_back(x * shot.pixel(), y * shot.pixel(), -depth);
      mesh.normals.emplace_back(0, 0, 1);
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(j * (shot.columns + 1) + i);
  };
  for (int j = 0; j < shot.rows; ++j) {
    for (int i = 0; i < shot.columns; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  mesh.material = 0;
  return mesh;
}

std::shared_ptr<PosedBy> rig_of(const Shot& shot) {
  Scene scene{.source = "pole"};
  scene.materials.emplace_back();
  scene.materials[0].unlit = scene.materials[0].double_sided = true;
  scene.meshes.push_back(pole_of(shot));
  scene.instances.push_back({"pole", 0, glm::dmat4(1.0)});
  scene.cameras = {camera_of(shot)};
  return std::make_shared<PosedBy>(scene, clip_seconds, [shot](double seconds, Scene& posed) {
    const glm::dvec3 way(shot.way * seconds * shot.pixel(), 0.0, 0.0);
    if (shot.camera_moves)
      posed.cameras[0].world_from_camera = glm::translate(glm::dmat4(1.0), -way);
    else
      posed.instances[0].world_from_mesh = glm::translate(glm::dmat4(1.0), way);
    if (shot.bends)
      for (std::size_t i = 0; i < posed.meshes[0].positions.size(); ++i)
        posed.meshes[0].positions[i].y += static_cast<float>(0.1 * shot.pixel() * seconds);
  });
}

ExposedScene exposed_shot(const Shot& shot, const RenderSettings& settings) {
  const auto rig = rig_of(shot);
  Camera camera = camera_of(shot);
  if (shot.camera_moves) camera = rig->pose(ClipTime{0, 0.5 * clip_seconds})->cameras[0];
  return exposed_at(*rig, 0.5 * clip_seconds, camera, settings);
}

/// Integral of the covered length of the unit interval left of s, from minus infinity to s.
double covered_integral(double s) {
  if (s <= 0.0) return 0.0;
  return s < 1.0 ? 0.5 * s * s : s - 0.5;
}

/// Mean over the exposure of the coverage of column `x`.
double streak(const Shot& shot, int x) {
  const auto mean = [&](double offset) {
    return (covered_integral(shot.from + shot.way + offset - x) -
            covered_integral(shot.from + offset - x)) /
           shot.way;
  };
  return mean(shot.pole) - mean(0.0);
}

double worst_error(const Shot& shot, const Picture& picture) {
  double worst = 0.0;
  for (int x = 0; x < shot.width; ++x) {
    const auto found =
        static_cast<double>(picture.film.radiance[picture.film.index(x, shot.height / 2)].x);
    worst = std::max(worst, std::abs(found - streak(shot, x)));
  }
  return worst;
}

/// The same exposure with only every n-th moment.
ExposedScene with_fewer_moments(const ExposedScene& shown, int n) {
  const Exposure& all = shown.exposure();
  Exposure few{.shutter = all.shutter, .step_pixels = n * all.step_pixels};
  for (int i = 0; i <= all.steps(); i += n)
    few.moments.push_back(all.moments[static_cast<std::size_t>(i)]);
  few.rays = std::make_shared<const MovingRays>(few.moments);
  RenderScene scene = *shown.scene;
  scene.exposure = std::make_shared<const Exposure>(std::move(few));
  return {std::make_shared<const RenderScene>(std::move(scene)), shown.camera};
}

// 128 steps of 20,000 triangles and more: copies would be limited to 64.
TEST(MovingMeshes, AreStoredOnceWhereCopiesAreTooMany) {
  Shot shot;
  shot.columns = 160, shot.rows = 125;
  const RenderSettings settings = settings_of(shot, Method::asos);
  const ExposedScene scene = exposed_shot(shot, settings);
  const Exposure& exposure = scene.exposure();
  EXPECT_FALSE(exposure.limited);
  EXPECT_EQ(exposure.steps(), Exposure::fine_steps);
  std::size_t own = 0;
  for (const auto& moment : exposure.moments) {
    const World& world = moment->world();
    ASSERT_TRUE(world.placements);
    EXPECT_EQ(world.placements->meshes, exposure.moments[0]->world().placements->meshes);
    own += world.triangles.own().size();
  }
  EXPECT_EQ(own, 0u);
  EXPECT_LT(worst_error(shot, render_exposed(scene, settings)), 2e-3);
  EXPECT_LT(worst_error(shot, render_exposed(scene, settings_of(shot, Method::sobol))), 6e-3);
}

TEST(MovingMeshes, ThatBendAreCopiedAndLimited) {
  Shot shot;
  shot.columns = 160, shot.rows = 125, shot.bends = true;
  const ExposedScene scene = exposed_shot(shot, settings_of(shot, Method::asos));
  const Exposure& exposure = scene.exposure();
  EXPECT_TRUE(exposure.limited);
  EXPECT_LE(static_cast<std::size_t>(exposure.steps() + 1) * 40'000, Exposure::most_triangles * 2);
  for (const auto& moment : exposure.moments) EXPECT_FALSE(moment->world().placements);
}

TEST(MovingMeshes, DoNotStrobeInLargePictures) {
  Shot shot;
  shot.width = 1280, shot.height = 720, shot.pole = 16.0, shot.way = 300.0;
  shot.columns = 100, shot.rows = 50;
  const ExposedScene scene = exposed_shot(shot, settings_of(shot, Method::asos));
  EXPECT_FALSE(scene.exposure().limited);
  EXPECT_EQ(scene.exposure().steps(), 512);
  EXPECT_LT(scene.exposure().step_pixels, Exposure::longest_step);
}

class FewMoments : public testing::TestWithParam<bool> {};

// Four steps of five pixels, and yet a smooth streak.
TEST_P(FewMoments, DoNotShowInSamples) {
  Shot shot;
  shot.camera_moves = GetParam();
  for (const auto& [method, tolerance] :
       {std::pair{Method::sobol, 6e-3}, std::pair{Method::mitchell, 6e-3},
        std::pair{Method::stochastic, 0.04}}) {
    const RenderSettings settings = settings_of(shot, method);
    const ExposedScene all = exposed_shot(shot, settings);
    const ExposedScene few = with_fewer_moments(all, all.exposure().steps() / 4);
    EXPECT_LT(worst_error(shot, render_exposed(few, settings)), tolerance) << row_of(method).name;
  }
}

TEST_P(FewMoments, DoNotShowInAsos) {
  Shot shot;
  shot.camera_moves = GetParam();
  const RenderSettings settings = settings_of(shot, Method::asos);
  const ExposedScene all = exposed_shot(shot, settings);
  const ExposedScene few = with_fewer_moments(all, all.exposure().steps() / 4);
  const Picture picture = render_exposed(few, settings);
  EXPECT_LT(worst_error(shot, picture), 0.02);
  const auto at = picture.film.index(shot.width / 2, shot.height / 2);
  EXPECT_EQ(picture.film.cause[at], SplitCause::motion);
}

INSTANTIATE_TEST_SUITE_P(OfPoleAndCamera, FewMoments, testing::Bool());

}  // namespace
}  // namespace asos::test::moving_meshes_test
