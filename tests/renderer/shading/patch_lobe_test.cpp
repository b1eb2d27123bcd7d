#include "renderer/shading/patch_lobe.h"

#include "renderer/lights/lighting.h"
#include "renderer/shading/surface.h"
#include "tests/support/tiny_world.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

glm::vec3 direction(float theta, float phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

BrdfAngles angles_of(glm::vec3 n, glm::vec3 h, glm::vec3 l, glm::vec3 v) {
  return {glm::dot(n, l), glm::dot(n, v), glm::dot(n, h), glm::dot(v, h)};
}

/// D alone: seen and lit along the normal, the shadowing term is 1/4.
float distribution(const PatchLobe& lobe, glm::vec3 n, glm::vec3 half) {
  BrdfAngles angles;
  angles.n_dot_l = angles.n_dot_v = 1.0f;
  angles.n_dot_h = glm::dot(n, half);
  return 4.0f * lobe.value(half, n, n, angles);
}

TEST(PatchLobe, IsTheMaterialsOwnWhereNormalsDoNotDiffer) {
  EXPECT_FALSE(PatchLobe({}, test::white_lobe(0.2f), {0, 0, 1}).wider());
  EXPECT_FALSE(PatchLobe({{1e-5f, 0, 0}, {}, 0.0f}, test::white_lobe(0.3f), {0, 0, 1}).wider());
  EXPECT_TRUE(PatchLobe({{0.1f, 0, 0}, {}, 0.0f}, test::white_lobe(0.3f), {0, 0, 1}).wider());
  EXPECT_TRUE(PatchLobe({{}, {}, 0.01f}, test::white_lobe(0.3f), {0, 0, 1}).wider());
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_FALSE(PatchLobe({{bad, 0, 0}, {}, 0.0f}, test::white_lobe(0.3f), {0, 0, 1}).wider());
    EXPECT_FALSE(PatchLobe({{}, {}, bad}, test::white_lobe(0.3f), {0, 0, 1}).wider());
  }
}

TEST(PatchLobe, MeetsTheMaterialsLobeAsTheSpreadVanishes) {
  const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  const glm::vec3 l = glm::normalize(glm::vec3(0.5f, -0.1f, 0.9f));
  const glm::vec3 v = glm::normalize(glm::vec3(-0.2f, -0.7f, 0.6f));
  const glm::vec3 h = glm::normalize(l + v);
  for (const float roughness : {0.05f, 0.3f, 0.8f}) {
    const float alpha = alpha_of(roughness);
    // Just above the limit of a thousandth of alpha^2 for ignored spreads: the jump is at most a
    // few thousandths.
    const float d = std::sqrt(1.1e-3f * 12.0f) * alpha;
    const PatchLobe lobe({d * glm::normalize(glm::cross(n, l)), {}, 0.0f},
                         test::white_lobe(roughness), n);
    ASSERT_TRUE(lobe.wider());
    const float own = ggx_lobe(roughness, angles_of(n, h, l, v));
    EXPECT_NEAR(lobe.value(h, l, v, angles_of(n, h, l, v)), own, 3e-3f * own) << roughness;
  }
}

TEST(PatchLobe, KeepsItsEnergy) {
  // The projected area of all microfacets is 1 for any roughness (Walter et al. 2007, eq. 4).
  const glm::vec3 n(0, 0, 1);
  for (const NormalSpread& spread : {NormalSpread{{0.3f, 0, 0}, {0, 0.05f, 0}, 0.0f},
                                     NormalSpread{{0.2f, 0.2f, 0}, {0, 0.1f, 0}, 0.02f},
                                     NormalSpread{{3.0f, 0, 0}, {0, 0, 0}, 0.5f}}) {
    for (const float roughness : {0.1f, 0.4f}) {
      const PatchLobe lobe(spread, test::white_lobe(roughness), n);
      ASSERT_TRUE(lobe.wider());
      constexpr int steps = 2000;
      constexpr int turns = 200;
      double sum = 0.0;
      for (int i = 0; i < steps; ++i) {
        // tan(theta) = x^2 / (1 - x^2), finest where the lobe is narrow.
        const float x = (static_cast<float>(i) + 0.5f) / steps;
        const float x2 = x * x;
        const float theta = std::atan(x2 / (1.0f - x2));
        const float d_theta =
            2.0f * x / ((1.0f - x2) * (1.0f - x2)) * std::cos(theta) * std::cos(theta) / steps;
        for (int j = 0; j < turns; ++j) {
          const float phi = 2.0f * pi * (static_cast<float>(j) + 0.5f) / turns;
          sum +=
              static_cast<double>(distribution(lobe, n, direction(theta, phi)) * std::cos(theta) *
                                  std::sin(theta) * d_theta * 2.0f * pi / turns);
        }
      }
      EXPECT_NEAR(sum, 1.0, 2e-3) << roughness;
    }
  }
}

// A patch whose normals vary by up to the lobe's width. The reference is the mean of the material's
// lobe over the box of slopes, by quadrature, for half vectors from the centre to four widths away.
// The patch's lobe has a smaller maximum error than the lobe at the centre.
TEST(PatchLobe, IsNearerToTheMeanOverABoxOfNormalsThanTheMiddlesLobe) {
  const glm::vec3 n(0, 0, 1);
  const float roughness = 0.2f;
  const float alpha = roughness * roughness;
  const auto ggx = [&](double x, double y) {
    const double s = 1.0 + (x * x + y * y) / (alpha * alpha);
    return 1.0 / (pi * alpha * alpha * s * s);
  };
  for (const float d : {0.25f * alpha, 0.5f * alpha, alpha}) {
    const PatchLobe lobe({{d, 0, 0}, {0, d, 0}, 0.0f}, test::white_lobe(roughness), n);
    double filtered = 0.0, middle = 0.0;
    for (const double away : {0.0, 0.5, 1.0, 2.0, 4.0}) {
      const double slope = away * static_cast<double>(alpha);
      double mean = 0.0;
      constexpr int steps = 200;
      for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
          mean += ggx(slope + d * ((i + 0.5) / steps - 0.5), d * ((j + 0.5) / steps - 0.5)) /
                  (steps * steps);
      const glm::vec3 half = glm::normalize(glm::vec3(static_cast<float>(slope), 0.0f, 1.0f));
      // Per slope, not per solid angle: D cos^4.
      const double cos4 = std::pow(static_cast<double>(half.z), 4.0);
      filtered = std::max(filtered,
                          std::abs(static_cast<double>(distribution(lobe, n, half)) * cos4 - mean));
      middle = std::max(middle, std::abs(ggx(slope, 0.0) - mean));
    }
    EXPECT_LT(filtered, middle) << d;
  }
}

// A flat patch close to light and viewer: the half vector varies over the patch, and the lobe is
// widened by that variation.
TEST(PatchLobe, SeesTheHalfVectorTurnAcrossAFlatPatch) {
  const glm::dvec3 eye(0.3, -0.2, 1.1), light(-0.6, 0.5, 0.7);
  const auto half_at = [&](glm::dvec3 p) {
    return glm::normalize(glm::normalize(eye - p) + glm::normalize(light - p));
  };
  const Patch patch{{0.01f, 0.002f, 0}, {-0.003f, 0.02f, 0}};
  const LobeGeometry sight{glm::vec3(glm::normalize(eye)), static_cast<float>(glm::length(eye)),
                           glm::vec3(glm::normalize(light)),
                           static_cast<float>(glm::length(light))};
  const NormalSpread normals{{0.05f, 0, 0}, {0, 0.01f, 0}, 0.002f};
  const NormalSpread spread = spread_about_half(normals, patch, sight);
  const auto turn = [&](glm::vec3 edge) {
    const glm::dvec3 step = 0.5 * glm::dvec3(edge);
    return glm::vec3(half_at(step) - half_at(-step));
  };
  EXPECT_LT(glm::length(spread.right - (normals.right - turn(patch.right))), 1e-5f);
  EXPECT_LT(glm::length(spread.down - (normals.down - turn(patch.down))), 1e-5f);
  EXPECT_EQ(spread.variance, normals.variance);
  // From far away nothing varies.
  constexpr float far = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(spread_about_half({}, patch, {sight.to_viewer, far, sight.to_light, far}).flat());
}

TEST(SurfacePoint, FlatSurfacesHaveNoSpreadAndCurvedOnesTheirTurn) {
  World flat;
  test::add_quad(flat, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, test::matte(glm::vec3(1)));
  World ball;
  Material shiny = test::matte(glm::vec3(1));
  shiny.roughness = 0.3f;
  test::add_sphere(ball, {0, 0, 0}, 2.0f, 64, shiny);
  const Light light;
  const auto lit = [&](const World& world) {
    return find_render_features(world).with(find_render_features({&light, 1}));
  };

  const PixelSpacing spacing{false, {0, -1, 0}, {0.01f, 0, 0}, {0, 0, 0.01f}};
  const MipChains none;
  Hit hit;
  hit.triangle = 0;
  hit.b1 = hit.b2 = 0.3f;
  hit.t = 5.0f;
  const SurfacePoint on_flat =
      surface_point(flat, lit(flat), hit, {0, 1, 0}, {&spacing, &none, 1.0f});
  EXPECT_EQ(on_flat.spread.right, glm::vec3(0.0f));
  EXPECT_EQ(on_flat.spread.down, glm::vec3(0.0f));
  EXPECT_EQ(on_flat.spread.variance, 0.0f);

  // A unit normal changes by (length along the surface) / radius.
  hit.triangle = 40;  // near the pole, where a ray from above is steep
  const SurfacePoint on_ball =
      surface_point(ball, lit(ball), hit, {0, 1, 0}, {&spacing, &none, 1.0f});
  EXPECT_NEAR(glm::length(on_ball.spread.right), 0.01f / 2.0f, 0.02f * 0.005f);
  EXPECT_NEAR(glm::length(on_ball.spread.down), 0.01f / 2.0f, 0.02f * 0.005f);
  EXPECT_EQ(surface_point(ball, lit(ball), hit, {0, 1, 0}).spread.right, glm::vec3(0.0f));
}

}  // namespace
}  // namespace asos
