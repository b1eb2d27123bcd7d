#include "renderer/samples/light_picks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace asos::test::light_picks_test {
namespace {

constexpr std::size_t point_count = 128;  // a number each, evenly spaced
constexpr std::size_t lights = 40;

// Light 0 is as bright as all others together, which differ.
float carried_by(std::size_t light) {
  return light == 0 ? 20.0f : static_cast<float>(light % 5 + 1) / 6.0f;
}

class Picked : public testing::Test {
 protected:
  Picked() {
    picks_.start(lights);
    for (std::size_t light = 0; light < lights; ++light) {
      ShadowRayBatch& rays = picks_.rays(light);
      rays.count = point_count;
      for (std::size_t i = 0; i < point_count; ++i) {
        rays.point[i] = static_cast<std::uint32_t>(i);
        for (auto& channel : rays.carried) channel[i] = carried_by(light);
        rays.t_far[i] = static_cast<float>(light) + 0.5f;
      }
    }
    const auto at = std::make_unique<LightPlaceBatch>();
    for (std::size_t i = 0; i < point_count; ++i)
      at->u[i] = static_cast<std::uint32_t>((i << 32) / point_count);
    picks_.pick(point_count, at->u, 8.0f);
  }

  LightPicks picks_;
};

TEST_F(Picked, AreSoManyAPoint) {
  std::vector<int> rays(point_count, 0);
  for (std::size_t light = 0; light < lights; ++light) {
    for (std::size_t i = 0; i < picks_.rays(light).count; ++i) ++rays[picks_.rays(light).point[i]];
  }
  // Half of the eight go into the bright light, which needs one.
  EXPECT_LE(*std::max_element(rays.begin(), rays.end()), 6);
  EXPECT_GE(*std::min_element(rays.begin(), rays.end()), 4);
}

TEST_F(Picked, CarryEachLightOnTheAverage) {
  for (std::size_t light = 0; light < lights; ++light) {
    const ShadowRayBatch& rays = picks_.rays(light);
    double sum = 0.0;
    for (std::size_t i = 0; i < rays.count; ++i) {
      EXPECT_EQ(rays.t_far[i], static_cast<float>(light) + 0.5f);
      sum += static_cast<double>(rays.carried[1][i]);
    }
    const double share = static_cast<double>(carried_by(light));
    // A light is picked by an interval of the points' numbers: one point too many, or too few.
    EXPECT_NEAR(sum / static_cast<double>(point_count), share, 5.0 / point_count) << light;
  }
}

TEST_F(Picked, AlwaysHoldWhatIsBrighterThanARaysShare) {
  const ShadowRayBatch& rays = picks_.rays(0);
  ASSERT_EQ(rays.count, point_count);
  EXPECT_EQ(rays.carried[0][17], carried_by(0));
}

// Of lights 1 to 9 each point has one ray, for a quarter of what all nine carry; and each is picked
// by as many points as it deserves.
TEST(OnePicked, CarriesAllAndComesFromEachByItsShare) {
  constexpr std::size_t first = 1, count = 9;
  LightPicks picks;
  picks.start(lights);
  double all = 0.0;
  for (std::size_t light = 0; light < lights; ++light) {
    ShadowRayBatch& rays = picks.rays(light);
    rays.count = point_count;
    for (std::size_t i = 0; i < point_count; ++i) {
      rays.point[i] = static_cast<std::uint32_t>(i);
      for (auto& channel : rays.carried) channel[i] = carried_by(light);
      rays.t_far[i] = static_cast<float>(light);
    }
    if (light >= first && light < first + count) all += static_cast<double>(carried_by(light));
  }
  const auto at = std::make_unique<LightPlaceBatch>();
  for (std::size_t i = 0; i < point_count; ++i)
    at->u[i] = static_cast<std::uint32_t>((i << 32) / point_count);
  const auto kept = std::make_unique<ShadowRayBatch>();
  picks.pick_one(point_count, {first, count}, at->u, 0.25f, *kept);

  ASSERT_EQ(kept->count, point_count);
  std::vector<int> from(lights, 0), of(point_count, 0);
  for (std::size_t i = 0; i < kept->count; ++i) {
    EXPECT_NEAR(static_cast<double>(kept->carried[2][i]), 0.25 * all, 1e-5);
    ++from[static_cast<std::size_t>(kept->t_far[i])];
    ++of[kept->point[i]];
  }
  EXPECT_EQ(*std::min_element(of.begin(), of.end()), 1);
  for (std::size_t light = 0; light < lights; ++light) {
    const bool asked = light >= first && light < first + count;
    const double share = asked ? static_cast<double>(carried_by(light)) / all : 0.0;
    EXPECT_NEAR(from[light], share * point_count, asked ? 1.0 : 0.0) << light;
  }
}

}  // namespace
}  // namespace asos::test::light_picks_test
