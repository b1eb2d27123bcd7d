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
    picks_.pick(point_count, at->u);
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

}  // namespace
}  // namespace asos::test::light_picks_test
