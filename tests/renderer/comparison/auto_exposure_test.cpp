#include "renderer/comparison/auto_exposure.h"

#include "renderer/gltf/load.h"
#include "tests/support/make_light.h"
#include "tests/support/quad_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos {
namespace {

/// A white matte unit square under a sun of `lux` that shines straight at it.
Scene sunlit_square(double lux) {
  Scene scene{.source = "square.glb"};
  test::add_object(scene, test::quad_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                   Material{.metallic = 0.0f, .roughness = 1.0f, .specular = 0.0f});
  scene.lights.push_back(test::make_sun({0, 0, -1}, static_cast<float>(lux)));
  return scene;
}

/// Meters a picture in which the square covers this fraction.
Metering metered(const RenderScene& scene, double share, RenderSettings settings = {},
                 bool usual = true) {
  Camera camera{.type = Camera::Type::orthographic, .height = std::sqrt(9.0 / 16.0 / share)};
  const glm::dvec3 origin = scene.world().origin;
  camera.world_from_camera[3] = glm::dvec4(0.5 - origin.x, 0.5 - origin.y, 5.0 - origin.z, 1.0);
  return usual ? usual_exposure(scene, camera, settings, ToneCurve::neutral)
               : meter(scene, camera, settings, ToneCurve::neutral);
}

// The square's radiance is E / pi, plus 0.21 of the neutral sky.
TEST(AutoExposure, BringsABrightSurfaceNearWhite) {
  for (const double lux : {100.0, 5000.0, 100000.0}) {
    const auto scene = prepare(sunlit_square(lux)).value();
    const Metering found = metered(*scene, 0.25);
    EXPECT_NEAR(found.whitened, 0.25, 0.02) << lux;
    const double radiance = lux / std::numbers::pi + 0.21;
    EXPECT_NEAR(static_cast<double>(found.stops), std::log2(0.8 / radiance), 0.051) << lux;
  }
}

TEST(AutoExposure, LeavesPicturesWithLittleWhiteAsTheyAre) {
  const auto bright = prepare(sunlit_square(5000.0)).value();
  EXPECT_EQ(metered(*bright, 0.05).stops, 0.0f);
  // Pixels at the square's edges are white, too: the square is 10.7 pixels wide.
  EXPECT_GE(metered(*bright, 0.05).whitened, 0.05);
  EXPECT_LE(metered(*bright, 0.05).whitened, 12.0 * 12.0 / (64.0 * 36.0));
  const auto dim = prepare(sunlit_square(2.0)).value();
  EXPECT_EQ(metered(*dim, 0.5).stops, 0.0f);
  EXPECT_EQ(metered(*dim, 0.5).whitened, 0.0);
}

TEST(AutoExposure, BrightensADarkPictureWhereItIsAskedFor) {
  RenderSettings settings{.sky = std::make_shared<const Sky>(glm::vec3(0.0f))};
  const auto dark = prepare(sunlit_square(0.1 * std::numbers::pi)).value();
  EXPECT_EQ(metered(*dark, 0.5, settings).stops, 0.0f);
  EXPECT_FLOAT_EQ(metered(*dark, 0.5, settings, false).stops, 3.0f);
}

TEST(AutoExposure, DependsOnNeitherSizeNorMethodNorThreads) {
  const auto scene = prepare(sunlit_square(5000.0)).value();
  RenderSettings large;
  const Metering first = metered(*scene, 0.25, large);
  large.width = 1920;
  large.height = 1080;
  large.threads = 7;
  large.method = Method::asos;
  large.seed = 5;
  large.crop = {3, 4, 5, 6};
  const Metering second = metered(*scene, 0.25, large);
  EXPECT_EQ(first.stops, second.stops);
  EXPECT_EQ(first.whitened, second.whitened);
}

TEST(AutoExposure, IsNotForDefaultLightingAndBuiltInScenes) {
  Scene unlit = sunlit_square(5000.0);
  unlit.lights.clear();
  EXPECT_FALSE(exposure_may_follow(*prepare(unlit).value()));
  EXPECT_FALSE(exposure_may_follow(*prepare(load_scene("builtin:boxes").value()).value()));
  EXPECT_TRUE(exposure_may_follow(*prepare(sunlit_square(1.0)).value()));
}

// Pixels of unlit surfaces do not depend on the exposure.
TEST(AutoExposure, UnlitSurfacesDoNotCount) {
  Scene scene = sunlit_square(5000.0);
  scene.materials[0].unlit = true;
  scene.materials[0].base_color = glm::vec4(1.0f);
  EXPECT_EQ(metered(*prepare(scene).value(), 0.5).whitened, 0.0);
}

}  // namespace
}  // namespace asos
