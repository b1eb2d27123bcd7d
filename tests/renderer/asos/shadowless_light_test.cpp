#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

// Lights that cast no shadows, by their own property or because shadows are off.

namespace asos::test::shadowless_light_test {
namespace {

/// A sphere on a floor and a blended pane above, for all kinds of shadows.
World furnished() {
  World world;
  add_quad(world, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, matte({0.6f, 0.5f, 0.4f}));
  add_sphere(world, {0.3f, 0.5f, 0}, 0.5f, 8, matte({0.7f, 0.2f, 0.2f}));
  Material pane = matte({1, 1, 1});
  pane.alpha_mode = AlphaMode::blend;
  pane.base_color.a = 0.5f;
  add_quad(world, {-0.9f, 0.8f, 0.6f}, {0.7f, 0, 0}, {0, 0.1f, -1}, pane);
  return world;
}

RenderSettings settings_for(Method method) {
  RenderSettings settings = make_settings(24, 16, method, 4);
  settings.asos.max_level = 2;
  settings.cull = false;
  return settings;
}

Picture picture_of(const std::vector<Light>& lights, const RenderSettings& settings) {
  const Camera camera = look_at({1.5, 2.5, 2.5}, {0, 0.2, 0}, 0.7);
  return render_picture(*make_render_scene(furnished(), lights), camera, settings);
}

constexpr Method methods[] = {Method::asos,       Method::asos_published, Method::uniform,
                              Method::stochastic, Method::sobol,          Method::sobol_adaptive};

TEST(ShadowlessLight, GivesThePictureWithoutShadowsBitForBit) {
  for (const Method method : methods) {
    RenderSettings settings = settings_for(method);
    for (Light light : all_lights()) {
      settings.shadow.cast = true;
      const Picture shadowed = picture_of({light}, settings);
      light.casts_shadows = false;
      const Picture by_light = picture_of({light}, settings);
      settings.shadow.cast = false;
      const Picture by_setting = picture_of({light}, settings);
      light.casts_shadows = true;
      const Picture by_setting_alone = picture_of({light}, settings);
      EXPECT_EQ(by_light.film.radiance, by_setting.film.radiance) << light.name;
      EXPECT_EQ(by_light.film.radiance, by_setting_alone.film.radiance) << light.name;
      EXPECT_EQ(by_light.film.split_level, by_setting_alone.film.split_level) << light.name;
      EXPECT_NE(by_light.film.radiance, shadowed.film.radiance) << light.name;
      for (const Picture* picture : {&by_light, &by_setting, &by_setting_alone}) {
        EXPECT_EQ(picture->statistics.shadow_rays, 0u) << light.name;
        EXPECT_EQ(picture->statistics.shadow_pyrays, 0u) << light.name;
        EXPECT_EQ(picture->statistics.pixels_by_cause[static_cast<std::size_t>(SplitCause::shadow)],
                  0u)
            << light.name;
      }
      EXPECT_GT(shadowed.statistics.shadow_rays, 0u) << light.name;
    }
  }
}

// One light with shadows and one without: each looks as it does alone.
TEST(ShadowlessLight, LeavesOtherLightsTheirShadows) {
  RenderSettings settings = settings_for(Method::asos);
  settings.asos.refine_shading = false;
  settings.asos.eps = 0.0;
  for (Light light : all_lights()) {
    Light free = point_light();
    free.position = {1, 2.5, 1};
    free.casts_shadows = false;
    const Picture dark = picture_of({}, settings);
    const Picture both = picture_of({light, free}, settings);
    const Picture first = picture_of({light}, settings), second = picture_of({free}, settings);
    for (std::size_t i = 0; i < dark.film.radiance.size(); ++i) {
      const glm::dvec3 sum = glm::dvec3(first.film.radiance[i]) +
                             glm::dvec3(second.film.radiance[i]) -
                             glm::dvec3(dark.film.radiance[i]);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(both.film.radiance[i][c], sum[c], 1e-6 * (1.0 + sum[c])) << light.name << i;
    }
    EXPECT_EQ(both.statistics.of_light(0), first.statistics.of_light(0)) << light.name;
    EXPECT_EQ(both.statistics.of_light(1), LightStatistics{}) << light.name;
  }
}

}  // namespace
}  // namespace asos::test::shadowless_light_test
