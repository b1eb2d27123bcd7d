#include "renderer/kernels/weigh_lights.h"

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/reflected_light.h"
#include "tests/support/every_target.h"
#include "tests/support/lit_subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace asos::test::weigh_lights_test {
namespace {

struct Table {
  std::vector<LightConstants> constants;
  std::vector<LightBounds> bounds;

  explicit Table(const std::vector<NamedLight>& lights) {
    for (const NamedLight& light : lights) constants.emplace_back(light.prepared);
    for (const LightConstants& light : constants) bounds.emplace_back(light);
  }
  [[nodiscard]] std::vector<float> weights(const ShadingPoints& points, std::size_t i) const {
    std::vector<float> weights((bounds.size() + 15) / 16 * 16);
    weigh_lights(bounds, points, i, weights);
    weights.resize(bounds.size());
    return weights;
  }
};

/// Contribution of each light's samples at each point, in the brightest channel.
struct Carried {
  std::vector<double> mean, root_mean_square, most;  ///< by point
};
Carried carried_of(const LitSubjects& batch, const LightConstants& light, std::uint32_t samples) {
  const std::size_t count = batch.subjects.size();
  Carried carried{std::vector<double>(count), std::vector<double>(count),
                  std::vector<double>(count)};
  const auto places = std::make_unique<LightPointBatch>();
  const auto rays = std::make_unique<ShadowRayBatch>();
  for (std::uint32_t s = 0; s < samples; ++s) {
    places->u.fill(owen_scramble(sobol_bits(SobolDimension::pixel_x, s), 5));
    places->v.fill(owen_scramble(sobol_bits(SobolDimension::pixel_y, s), 7));
    shade_batch(batch.points, light, *places, *rays);
    for (std::size_t k = 0; k < rays->count; ++k) {
      const auto one = static_cast<double>(
          std::max({rays->carried[0][k], rays->carried[1][k], rays->carried[2][k]}));
      const std::size_t i = rays->point[k];
      carried.mean[i] += one / samples;
      carried.root_mean_square[i] += one * one / samples;
      carried.most[i] = std::max(carried.most[i], one);
    }
  }
  for (double& square : carried.root_mean_square) square = std::sqrt(square);
  return carried;
}

// A contributing light without a weight is never selected, and the mean misses it.
TEST(WeighLights, GivesEveryContributingLightAWeight) {
  for (const auto& [scale, offset] : scales) {
    const LitSubjects batch(17, scale, offset);
    const std::vector<NamedLight> all = lights(scale, offset);
    const Table table(all);
    for (std::size_t light = 0; light < all.size(); ++light) {
      SCOPED_TRACE(all[light].name + " at scale " + std::to_string(std::log10(scale)));
      const Carried carried = carried_of(batch, table.constants[light], 256);
      const double bright = *std::max_element(carried.most.begin(), carried.most.end());
      ASSERT_GT(bright, 0.0);
      for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
        const float weight = table.weights(batch.points, i)[light];
        EXPECT_TRUE(std::isfinite(weight));
        EXPECT_GE(weight, 0.0f);
        // At the horizon, weight and contribution may differ by rounding.
        if (carried.most[i] > 1e-6 * bright) {
          EXPECT_GT(weight, 0.0f) << "point " << i << " carries " << carried.most[i];
        }
      }
    }
  }
}

// With selection probabilities w, the variance is the sum of E[c^2] / w; small w give noise. The
// optimal w is the root of E[c^2].
TEST(WeighLights, IsNearTheOptimalWeights) {
  const LitSubjects batch(18, 1.0, {0, 0, 0});
  const std::vector<NamedLight> all = lights(1.0, {0, 0, 0});
  const Table table(all);
  std::vector<double> ratios;
  for (std::size_t light = 0; light < all.size(); ++light) {
    if (all[light].prepared.rule == LightRule::published) continue;
    const Carried carried = carried_of(batch, table.constants[light], 256);
    for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
      const auto weight = static_cast<double>(table.weights(batch.points, i)[light]);
      if (carried.root_mean_square[i] > 1e-4)
        ratios.push_back(weight / carried.root_mean_square[i]);
    }
  }
  ASSERT_GT(ratios.size(), 1000u);
  std::sort(ratios.begin(), ratios.end());
  const auto at = [&](double part) {
    return ratios[static_cast<std::size_t>(part * static_cast<double>(ratios.size()))];
  };
  EXPECT_GT(ratios.front(), 0.1);
  EXPECT_GT(at(0.01), 0.35);
  EXPECT_NEAR(at(0.5), 1.0, 0.4);
}

// On a white point without highlight, far from a light of any type, the weight is the reflected
// radiance.
TEST(WeighLights, IsTheIrradianceOfSmallLights) {
  LitSubject s;
  s.point->position = {0.0f, -40.0f, 0.0f};
  s.point->shading_normal = s.point->geometric_normal = {0, 1, 0};
  s.view = std::make_unique<ViewedPoint>(ViewedPoint{*s.point, {0, 1, 0}, 1.0f});
  s.material.diffuse = glm::vec3(1.0f);
  ShadingPoints points;
  points.add(s.lit(), glm::vec3(1.0f));
  const std::vector<NamedLight> all = lights(1.0, {0, 0, 0});
  const Table table(all);
  const std::vector<float> weights = table.weights(points, 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::vec3 e = unshadowed_irradiance(all[i].prepared, receiver_at(*s.point));
    const double radiance = static_cast<double>(std::max({e.x, e.y, e.z})) * std::numbers::inv_pi;
    if (all[i].name == "spot") {
      EXPECT_EQ(weights[i], 0.0f) << "it is beyond its range";
      continue;
    }
    ASSERT_GT(radiance, 0.0) << all[i].name;
    EXPECT_NEAR(static_cast<double>(weights[i]) / radiance, 1.0, 0.03) << all[i].name;
  }
}

// A wall light: a floor point next to it sees half of its hemisphere filled, whatever the light's
// length and centre.
TEST(WeighLights, UsesTheNearPartOfLargeLights) {
  LitSubject s;
  s.point->shading_normal = s.point->geometric_normal = {0, 1, 0};
  s.view = std::make_unique<ViewedPoint>(ViewedPoint{*s.point, {0, 1, 0}, 1.0f});
  s.material.diffuse = glm::vec3(1.0f);
  ShadingPoints points;
  points.add(s.lit(), glm::vec3(1.0f));
  for (const double length : {1.0, 10.0, 100.0}) {
    for (const double below : {0.0, 5.0}) {
      Light wall = rectangle_light();
      // At a distance of 0.1, from `below` under the floor to 1 above it; the point is near one
      // end.
      wall.half_u = {0.0, 0.5 * (1.0 + below), 0.0};
      wall.half_v = {0.0, 0.0, length};
      wall.direction = {-1, 0, 0};
      wall.position = {0.1, 0.5 * (1.0 - below), 0.9 * length};
      const NamedLight named{"wall", prepare_light(wall)};
      const Table table({named});
      const glm::vec3 e = unshadowed_irradiance(named.prepared, receiver_at(*s.point));
      const double radiance = static_cast<double>(std::max({e.x, e.y, e.z})) * std::numbers::inv_pi;
      const auto weight = static_cast<double>(table.weights(points, 0)[0]);
      EXPECT_GT(weight, radiance / 3.0) << length << ' ' << below;
      EXPECT_LT(weight, radiance * 3.0) << length << ' ' << below;
    }
  }
}

// Lights in lanes have the bits of points in lanes.
TEST(WeighLights, WeighsAlikeByAllInstructions) {
  const LitSubjects batch(19, 1.0, {0, 0, 0});
  const Table table(lights(1.0, {0, 0, 0}));
  ASSERT_NE(table.bounds.size() % 4, 0u);
  const std::size_t points = batch.subjects.size();
  std::vector<ShadingPoints::Floats> first;
  for_every_target([&] {
    std::vector<ShadingPoints::Floats> weights(table.bounds.size());
    weigh_lights(table.bounds, batch.points, weights);
    if (first.empty()) first = weights;
    for (std::size_t i = 0; i < points; ++i) {
      const std::vector<float> at = table.weights(batch.points, i);
      for (std::size_t light = 0; light < weights.size(); ++light) {
        const auto bits = std::bit_cast<std::uint32_t>(first[light][i]);
        EXPECT_EQ(std::bit_cast<std::uint32_t>(weights[light][i]), bits) << light << ' ' << i;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(at[light]), bits) << light << ' ' << i;
      }
    }
  });
}

}  // namespace
}  // namespace asos::test::weigh_lights_test
