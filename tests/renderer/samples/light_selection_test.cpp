#include "renderer/samples/light_selection.h"

#include "tests/support/lit_subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace asos::test::light_picks_test {
namespace {

constexpr std::size_t point_count = 128;  // one number each, evenly spaced
constexpr std::size_t light_count = 40;
constexpr float rays_a_point = 8.0f;

// Light 0 is as bright as all others together, which differ; the last is below the floor.
float brightness(std::size_t light) {
  return light == 0 ? 20.0f : static_cast<float>(light % 5 + 1) / 6.0f;
}

/// Points at the same place of a floor, under lights of one height.
class Picked : public testing::Test {
 protected:
  Picked() {
    at_.shading_normal = at_.geometric_normal = {0, 1, 0};
    for (std::size_t i = 0; i < light_count; ++i) {
      Light light = point_light();
      light.color = glm::vec3(1.0f);
      light.intensity = brightness(i);
      if (i + 1 == light_count) light.position.y = -2.0;
      prepared_.push_back(prepare_light(light));
    }
    for (std::uint32_t i = 0; i < light_count; ++i) {
      constants_.emplace_back(prepared_[i]);
      table_.add(constants_.back(), i);
    }
    const ViewedPoint view{at_, {0, 1, 0}, 1.0f};
    for (std::size_t i = 0; i < point_count; ++i)
      points_->add({prepared_, view, material_}, glm::vec3(1.0f));
    for (std::size_t i = 0; i < point_count; ++i)
      numbers_->u[i] = static_cast<std::uint32_t>((i << 32) / point_count);
    picks_.pick(table_, *points_, numbers_->u, rays_a_point);
  }

  SurfacePoint at_;
  ViewedMaterial material_{glm::vec3(1.0f), glm::vec3(0.0f), glm::vec3(0.0f), 1.0f,
                           glm::vec3(0.0f)};
  std::vector<PreparedLight> prepared_;
  std::vector<LightConstants> constants_;
  LightTable table_;
  std::unique_ptr<ShadingPoints> points_ = std::make_unique<ShadingPoints>();
  std::unique_ptr<LightPointBatch> numbers_ = std::make_unique<LightPointBatch>();
  LightSelection picks_;
};

TEST_F(Picked, AreEvenlySpreadOverPoints) {
  std::vector<int> rays(point_count, 0);
  for (std::size_t light = 0; light < light_count; ++light)
    for (const std::uint32_t point : picks_.of(light).point) ++rays[point];
  // One ray goes to the bright light, which has half of the weight, and the others get seven.
  EXPECT_EQ(*std::max_element(rays.begin(), rays.end()), 8);
  EXPECT_GE(*std::min_element(rays.begin(), rays.end()), 7);
}

TEST_F(Picked, StandForEachLightOnTheAverage) {
  for (std::size_t light = 0; light + 1 < light_count; ++light) {
    const LightSelection::Points picked = picks_.of(light);
    ASSERT_EQ(picked.point.size(), picked.weight.size());
    EXPECT_TRUE(std::is_sorted(picked.point.begin(), picked.point.end()));
    double sum = 0.0;
    for (const float weight : picked.weight) sum += static_cast<double>(weight);
    // A light is selected by an interval of the points' numbers: one point more or less is
    // possible.
    const double probability =
        std::min(1.0, static_cast<double>(brightness(light) * (rays_a_point - 1.0f) / 19.0f));
    EXPECT_NEAR(sum / point_count, 1.0, 1.5 / (probability * point_count)) << light;
  }
}

TEST_F(Picked, AlwaysIncludeBrightLights) {
  const LightSelection::Points picked = picks_.of(0);
  ASSERT_EQ(picked.point.size(), point_count);
  for (const float weight : picked.weight) EXPECT_EQ(weight, 1.0f);
}

TEST_F(Picked, NeverIncludeLightsWithoutContribution) {
  EXPECT_TRUE(picks_.of(light_count - 1).point.empty());
}

TEST_F(Picked, AreNoneWhereAllIsDark) {
  points_->diffuse = {};
  picks_.pick(table_, *points_, numbers_->u, rays_a_point);
  for (std::size_t light = 0; light < light_count; ++light)
    EXPECT_TRUE(picks_.of(light).point.empty()) << light;
}

}  // namespace
}  // namespace asos::test::light_picks_test
