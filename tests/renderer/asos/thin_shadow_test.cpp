#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <string>
#include <utility>

// Shadows of many thin objects, which are sampled by rays.

namespace asos::test::thin_shadow_test {
namespace {

/// Mean of a picture of a floor under a lamp straight above it, behind `slats` slats.
double mean_behind(int slats, float period, float share) {
  World world;
  add_quad(world, {-8, 0, 8}, {16, 0, 0}, {0, 0, -16}, matte(glm::vec3(0.5f)));
  for (int i = -slats / 2; i < slats / 2; ++i)
    add_quad(world, {static_cast<float>(i) * period, 3, 4}, {share * period, 0, 0}, {0, 0, -8},
             matte(glm::vec3(0.0f)));
  const Light lamp = make_sun({0, -1, 0}, 0.7f);
  RenderSettings settings = make_settings(48, 48);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  settings.cull = false;
  const auto scene = make_render_scene(std::move(world), {lamp});
  const Camera camera = look_at({0, 2.5, 0}, {0.013, 0, 0.017}, 0.5);
  const Film film = render_picture(*scene, camera, settings).film;
  double mean = 0.0;
  for (const glm::vec3& pixel : film.radiance) mean += static_cast<double>(pixel.y);
  return mean / static_cast<double>(film.radiance.size());
}

// Slats hide a twentieth of the lamp, with a few of them above each pixel. Stopping once rays agree
// would favour the majority: that was 0.02 too bright; 0.004 remain.
TEST(ThinShadow, DarknessMatchesTheWidthOfSlats) {
  for (const float period : {0.0093f, 0.0131f, 0.0187f}) {
    const double lit = mean_behind(400, period, 0.05f) / mean_behind(0, period, 0.05f);
    RecordProperty("off_" + std::to_string(period), std::to_string(lit - 0.95));
    EXPECT_NEAR(lit, 0.95, 0.006) << period;
  }
}

}  // namespace
}  // namespace asos::test::thin_shadow_test
