#include "renderer/asos/unshadowed_contributions.h"

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

/// A white surface point that faces up.
struct WhiteFloor {
  explicit WhiteFloor(glm::vec3 position) {
    at.position = position;
    at.geometric_normal = at.shading_normal = {0, 1, 0};
  }
  SurfacePoint at;
  ViewedPoint view = viewed_point(at, {0, 1, 0});
  ViewedMaterial material{{glm::vec3(0.0f), glm::vec3(0.0f), 1.0f}, glm::vec3(1.0f)};
};

// The maximum over the shading points; zero without any.
TEST(UnshadowedContributions, MatchesRadianceOfAWhiteFloor) {
  std::vector<Light> lights{point_light(), rectangle_light()};
  for (Light& light : lights) light.intensity = 0.2f;
  const std::vector<PreparedLight> all = prepared(lights);
  UnshadowedContributions carried(all);
  const WhiteFloor far({9, 0, 0}), below({0, 0, 0});
  for (const WhiteFloor* floor : {&far, &below})
    (void)carried.gather({all, floor->view, floor->material});
  const std::vector<double> most = carried.most();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::vec3 e = unshadowed_irradiance(all[i], {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}});
    const double radiance = static_cast<double>(e.x) * std::numbers::inv_pi;
    // The rectangle's width is a third of its distance.
    EXPECT_NEAR(most[i], radiance, 0.25 * radiance) << i;
  }
  for (const double one : UnshadowedContributions(all).most()) EXPECT_EQ(one, 0.0);
}

// At most two sides of a part's faces are visible from anywhere, however many faces there are.
TEST(UnshadowedContributions, IsLimitedToTwoSidesOfOnePart) {
  std::vector<PreparedLight> all = prepared(std::vector<Light>(40, rectangle_light()));
  for (PreparedLight& light : all) light.own_part = 3;
  UnshadowedContributions carried(all);
  const WhiteFloor floor({0, 0, 0});
  (void)carried.gather({all, floor.view, floor.material});
  double sum = 0.0;
  for (const double one : carried.most()) sum += one;
  EXPECT_NEAR(sum, 2.0, 1e-6) << "each light alone is brighter than white";
}

}  // namespace
}  // namespace asos::test::carried_light_test
