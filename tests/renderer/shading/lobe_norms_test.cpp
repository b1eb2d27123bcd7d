#include "renderer/shading/lobe_norms.h"

#include "renderer/shading/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos::lobe_norms_test {
namespace {

/// Integrates brdf.h's lobe over directions to the light, in equal steps of the polar angle and the
/// azimuth. The table integrates over normals instead.
LobeNorms by_directions(float n_dot_v, float roughness) {
  constexpr int polar = 600;
  constexpr int around = 300;
  const double sine = std::sqrt(1.0 - static_cast<double>(n_dot_v) * static_cast<double>(n_dot_v));
  double lobe = 0.0, fresnel = 0.0;
  for (int i = 0; i < polar; ++i) {
    const double angle = 0.5 * std::numbers::pi * (i + 0.5) / polar;
    const double z = std::cos(angle);
    for (int k = 0; k < around; ++k) {
      const double x = std::sin(angle) * std::cos(std::numbers::pi * (k + 0.5) / around);
      // Half of the sum of both directions has the length v.h.
      const double v_dot_h = std::sqrt(0.5 * (1.0 + x * sine + z * static_cast<double>(n_dot_v)));
      const auto n_dot_h = static_cast<float>(0.5 * (z + static_cast<double>(n_dot_v)) / v_dot_h);
      const BrdfAngles angles{static_cast<float>(z), n_dot_v, n_dot_h, static_cast<float>(v_dot_h)};
      const double value = static_cast<double>(ggx_lobe(roughness, angles)) * z * std::sin(angle);
      lobe += value;
      fresnel += value * std::pow(1.0 - v_dot_h, 5.0);
    }
  }
  const double each = 2.0 * std::numbers::pi * 0.5 * std::numbers::pi / (polar * around);
  return {static_cast<float>(lobe * each), static_cast<float>(fresnel * each)};
}

TEST(LobeNorms, AreTheLobesIntegrals) {
  for (const float n_dot_v : {0.05f, 0.1f, 0.23f, 0.5f, 0.77f, 1.0f}) {
    for (const float roughness : {0.33f, 0.45f, 0.7f, 1.0f}) {
      const LobeNorms found = lobe_norms(n_dot_v, roughness);
      const LobeNorms truth = by_directions(n_dot_v, roughness);
      EXPECT_NEAR(found.lobe, truth.lobe, 3e-3f) << n_dot_v << " " << roughness;
      EXPECT_NEAR(found.fresnel, truth.fresnel, 3e-3f) << n_dot_v << " " << roughness;
    }
  }
}

TEST(LobeNorms, OfFullRoughnessSeenSquareOnIsItsClosedForm) {
  EXPECT_NEAR(lobe_norms(1.0f, 1.0f).lobe, 1.0f - std::numbers::ln2_v<float>, 3e-4f);
}

TEST(LobeNorms, OfAMirrorAreSchlicksFresnelTerm) {
  for (const float n_dot_v : {0.01f, 0.2f, 0.5f, 0.9f, 1.0f}) {
    EXPECT_EQ(lobe_norms(n_dot_v, 0.0f).lobe, 1.0f);
    EXPECT_NEAR(lobe_norms(n_dot_v, 0.0f).fresnel, std::pow(1.0f - n_dot_v, 5.0f), 2e-3f);
  }
}

TEST(LobeNorms, OutsideOfTheirRangeAreThoseOfItsEndsAndNeverHideWhatIsNoNumber) {
  EXPECT_EQ(lobe_norms(2.0f, 3.0f).lobe, lobe_norms(1.0f, 1.0f).lobe);
  EXPECT_EQ(lobe_norms(-1.0f, -1.0f).fresnel, lobe_norms(0.0f, 0.0f).fresnel);
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(lobe_norms(none, 0.5f).lobe));
  EXPECT_TRUE(std::isnan(lobe_norms(0.5f, none).fresnel));
}

// Energy conservation: no lobe reflects more than it receives.
TEST(LobeNorms, NeverExceedOne) {
  for (int c = 0; c <= 100; ++c) {
    for (int r = 0; r <= 100; ++r) {
      const LobeNorms norms = lobe_norms(static_cast<float>(c) / 100, static_cast<float>(r) / 100);
      EXPECT_LE(norms.lobe, 1.0f);
      EXPECT_LE(norms.fresnel, norms.lobe);
      EXPECT_GE(norms.fresnel, 0.0f);
    }
  }
}

}  // namespace
}  // namespace asos::lobe_norms_test
