#include "renderer/kernels/light_selection.h"

#include "tests/support/every_target.h"
#include "tests/support/lit_subjects.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
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
      bounds_.emplace_back(constants_.back());
    }
    const ViewedPoint view{at_, {0, 1, 0}, 1.0f};
    for (std::size_t i = 0; i < point_count; ++i)
      points_->add({prepared_, view, material_}, glm::vec3(1.0f));
    for (std::size_t i = 0; i < point_count; ++i)
      numbers_->u[i] = static_cast<std::uint32_t>((i << 32) / point_count);
    picks_.pick(bounds_, *points_, numbers_->u, rays_a_point);
  }

  SurfacePoint at_;
  ViewedMaterial material_{{glm::vec3(0.0f), glm::vec3(0.0f), 1.0f}, glm::vec3(1.0f)};
  std::vector<PreparedLight> prepared_;
  std::vector<LightConstants> constants_;
  std::vector<LightBounds> bounds_;
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
  picks_.pick(bounds_, *points_, numbers_->u, rays_a_point);
  for (std::size_t light = 0; light < light_count; ++light)
    EXPECT_TRUE(picks_.of(light).point.empty()) << light;
}

/// The picks of one point: walks along the lights, one by one.
std::vector<std::pair<std::size_t, float>> picks_of_point(const std::vector<float>& weights,
                                                          float all, float number, float a_point) {
  std::vector<std::pair<std::size_t, float>> picks;
  if (!(all > 1e-30f)) return picks;
  float share = all / a_point;
  for (int round = 0; round < 2; ++round) {
    float rest = 0.0f, taken = 0.0f;
    for (const float weight : weights)
      (weight < share ? rest : taken) += weight < share ? weight : 1.0f;
    if (taken == 0.0f || rest == 0.0f) break;
    share = std::min(share, rest / std::max(1.0f, a_point - taken));
  }
  const float per_share = 1.0f / share;
  for (std::size_t light = 0; light < weights.size(); ++light) {
    if (weights[light] >= share) {
      picks.emplace_back(light, 1.0f);
      continue;
    }
    const float probability = weights[light] * per_share;
    number += probability;
    if (number < 1.0f) continue;
    number -= 1.0f;
    picks.emplace_back(light, 1.0f / probability);
  }
  return picks;
}

// Points in lanes have the bits of lights in lanes, and of a walk along them.
TEST(LightSelection, PicksForABatchAsForItsPointsOneByOne) {
  const LitSubjects batch(21, 1.0, {0, 0, 0});
  const std::vector<NamedLight> all = lights(1.0, {0, 0, 0});
  std::vector<LightBounds> bounds;
  std::vector<LightConstants> constants;
  for (const int copies : {1, 3}) {
    bounds.clear();
    constants.clear();
    for (int k = 0; k < copies; ++k)
      for (const NamedLight& light : all) constants.emplace_back(light.prepared);
    for (const LightConstants& light : constants) bounds.emplace_back(light);
    for_every_target([&] {
      LightSelection picks;
      picks.pick(bounds, batch.points, batch.places.u, rays_a_point);
      std::vector<std::vector<std::pair<std::size_t, float>>> found(batch.points.count);
      for (std::size_t light = 0; light < bounds.size(); ++light) {
        const LightSelection::Points by = picks.of(light);
        for (std::size_t k = 0; k < by.point.size(); ++k)
          found[by.point[k]].emplace_back(light, by.weight[k]);
      }
      std::size_t picked = 0;
      for (std::size_t i = 0; i < batch.points.count; ++i) {
        std::vector<float> weights((bounds.size() + 15) / 16 * 16);
        weigh_lights(bounds, batch.points, i, weights);
        weights.resize(bounds.size());
        const float sum = std::accumulate(weights.begin(), weights.end(), 0.0f);
        const float number = static_cast<float>(batch.places.u[i] >> 8) * 0x1p-24f;
        EXPECT_EQ(found[i], picks_of_point(weights, sum, number, rays_a_point)) << "point " << i;
        picked += found[i].size();
      }
      EXPECT_GT(picked, batch.points.count);
    });
  }
}

}  // namespace
}  // namespace asos::test::light_picks_test
