#include "renderer/asos/carried_light.h"

#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace asos::test::carried_light_test {
namespace {

std::vector<PreparedLight> prepared(const std::vector<Light>& lights) {
  std::vector<PreparedLight> all;
  for (const Light& light : lights) all.push_back(prepare_light(light));
  return all;
}

/// White, and turned to what is above.
struct WhiteFloor {
  explicit WhiteFloor(glm::vec3 position) {
    at.position = position;
    at.geometric_normal = at.shading_normal = {0, 1, 0};
  }
  SurfacePoint at;
  ViewedPoint view = viewed_point(at, {0, 1, 0});
  ViewedMaterial material{glm::vec3(1.0f), glm::vec3(0.0f), glm::vec3(0.0f), 1.0f, glm::vec3(0.0f)};
};

// Far from a light of any type, that it is so near is what its irradiance says of a white wall.
TEST(CarriedLight, NearALightIsWhereItsIrradianceIsAsMuch) {
  for (const Light& light : {point_light(), ball_light(), linear_light(), rectangle_light(),
                             disk_light(), polygon_light()}) {
    const std::vector<PreparedLight> lights = prepared({light});
    const CarriedLight carried(lights);
    const glm::dvec3 below(light.position.x, light.position.y - 40.0, light.position.z);
    const glm::vec3 e = unshadowed_irradiance(lights[0], {below, {0, 1, 0}, {0, 1, 0}});
    const double radiance = static_cast<double>(std::max({e.x, e.y, e.z})) * std::numbers::inv_pi;
    ASSERT_GT(radiance, 1e-4) << light.name;
    EXPECT_TRUE(carried.near(glm::vec3(below), 0.95 * radiance)) << light.name;
    EXPECT_FALSE(carried.near(glm::vec3(below), 1.05 * radiance)) << light.name;
    EXPECT_NEAR(carried.by_white_walls(glm::vec3(below)), radiance, 0.05 * radiance) << light.name;
  }
}

TEST(CarriedLight, SunsAreNearNowhere) {
  for (const Light& light : {sun_light(), distant_light()}) {
    const std::vector<PreparedLight> lights = prepared({light});
    EXPECT_FALSE(CarriedLight(lights).near({0, 0, 0}, 1e-6)) << light.name;
    EXPECT_EQ(CarriedLight(lights).by_white_walls({0, 0, 0}), 1.0) << "white at most";
  }
}

// By way of the brightest of the places, and of none once they are forgotten.
TEST(CarriedLight, IsWhatAWhiteFloorShowsOfIt) {
  std::vector<Light> lights{point_light(), rectangle_light()};
  for (Light& light : lights) light.intensity = 0.2f;
  const std::vector<PreparedLight> all = prepared(lights);
  CarriedLight carried(all);
  const WhiteFloor far({9, 0, 0}), below({0, 0, 0});
  for (const WhiteFloor* floor : {&far, &below}) carried.add({all, floor->view, floor->material});
  const std::vector<double> most = carried.most();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::vec3 e = unshadowed_irradiance(all[i], {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}});
    const double radiance = static_cast<double>(e.x) * std::numbers::inv_pi;
    // Four places of the rectangle, each as if all of it lay there.
    EXPECT_NEAR(most[i], radiance, 0.25 * radiance) << i;
  }
  carried.start();
  for (const double one : carried.most()) EXPECT_EQ(one, 0.0);
}

// The faces of one part are seen from two sides at most, however many they are.
TEST(CarriedLight, OfOnePartHidesEachOther) {
  std::vector<PreparedLight> all = prepared(std::vector<Light>(40, rectangle_light()));
  for (PreparedLight& light : all) light.own_part = 3;
  CarriedLight carried(all);
  const WhiteFloor floor({0, 0, 0});
  carried.add({all, floor.view, floor.material});
  double sum = 0.0;
  for (const double one : carried.most()) sum += one;
  EXPECT_NEAR(sum, 2.0, 1e-6) << "each is whiter than white";
}

}  // namespace
}  // namespace asos::test::carried_light_test
