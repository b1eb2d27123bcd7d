#include "renderer/shading/dfr.h"

#include "renderer/shading/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(Dfr, WidensPyraysAsThePapersTable) {
  // CGF'98, table 1: beta = 2 degrees, alpha = 0.
  constexpr int published[] = {890, 399, 233, 150, 100, 67, 43, 25, 11};
  for (int i = 0; i < 9; ++i) {
    const DfrCurve curve{0.1 * (i + 1), 1.0, 1.0};
    const double increase = percentage_increase(2.0 * degree, dfr_at(curve, 1.0));
    EXPECT_EQ(std::lround(increase), published[i]) << curve.min;
  }
}

TEST(Dfr, FollowsThePapersFigureOverTheIncidenceAngle) {
  // CGF'98, figure 7: every ten degrees from 0 to 90, from the text's formula by independent code.
  struct Curve {
    double exponent;
    double increase[10];
  };
  constexpr Curve curves[] = {
      {1,
       {66.636593, 51.317197, 38.932296, 29.023548, 21.209921, 15.188215, 10.726077, 7.653356,
        5.854352, 5.262003}},
      {2,
       {66.636593, 63.757761, 55.997589, 45.438072, 34.287253, 24.156863, 15.937977, 10.001663,
        6.444252, 5.262003}},
      {4,
       {66.636593, 66.548306, 65.317732, 60.778137, 51.552599, 38.774278, 25.482873, 14.556385,
        7.616496, 5.262003}},
      {8,
       {66.636593, 66.636512, 66.618404, 66.257963, 63.852605, 55.860819, 40.684003, 23.026344,
        9.929321, 5.262003}},
      {16,
       {66.636593, 66.636593, 66.636589, 66.635110, 66.554120, 65.281526, 57.446863, 37.091958,
        14.417771, 5.262003}},
  };
  for (const Curve& expected : curves) {
    const DfrCurve curve{0.6, 0.95, expected.exponent};
    for (int i = 0; i < 10; ++i) {
      const double cosine = std::cos(10.0 * i * degree);
      EXPECT_NEAR(percentage_increase(2.0 * degree, dfr_at(curve, cosine)), expected.increase[i],
                  1e-6)
          << "N = " << expected.exponent << ", " << 10 * i << " degrees";
    }
  }
}

TEST(Dfr, HasDefinedLimits) {
  EXPECT_EQ(dfr_at(DfrCurve{}, 0.3), 1.0) << "a mirror";
  EXPECT_EQ(dfr_at({0.0, 0.0, 1.0}, 0.3), least_dfr);
  EXPECT_EQ(dfr_at({0.9, 0.1, 1.0}, 1.0), 0.9) << "may fall with the angle";
  EXPECT_EQ(dfr_at({0.9, 0.1, 1.0}, 0.0), 0.1);
  EXPECT_EQ(dfr_at({0.2, 0.7, 0.0}, 1.0), 0.7) << "sin^0 is 1, also for an angle of 0";
  EXPECT_EQ(dfr_at({0.2, 0.7, 0.0}, 0.4), 0.7);
  EXPECT_EQ(dfr_at({0.2, 0.7, 1e4}, 0.1), 0.2);
  EXPECT_EQ(dfr_at({0.2, 0.7, 1e4}, 0.0), 0.7);
  EXPECT_EQ(dfr_at({0.2, 0.7, 2.0}, -0.6), dfr_at({0.2, 0.7, 2.0}, 0.6)) << "either side";
  EXPECT_EQ(dfr_at({0.2, 0.7, 2.0}, std::nextafter(1.0, 2.0)), 0.2) << "a rounded cosine";
  EXPECT_TRUE(std::isnan(dfr_at({0.2, 0.7, 2.0}, std::numeric_limits<double>::quiet_NaN())));
}

TEST(Dfr, LeavesAMirrorsPyrayAloneAndKeepsOthersBelowAHalfSpace) {
  for (double beta : {1e-6, 0.01, 1.0, 3.0}) {
    EXPECT_NEAR(widened_angle(beta, 1.0), beta, 1e-15 * beta + 1e-15);
    EXPECT_LT(widened_angle(beta, 0.0), std::numbers::pi);
    EXPECT_EQ(widened_angle(beta, 0.0), widened_angle(beta, least_dfr));
  }
  EXPECT_DOUBLE_EQ(widened_half_tangent(0.02, 0.25), 0.08);
}

TEST(Dfr, IsPerturbedByPlaceAlone) {
  const Dfr dfr{{{{0.4, 0.8, 2.0}, {0.5, 0.8, 2.0}, {0.9, 1.0, 2.0}}}, 0.3};
  double sum = 0.0, least = 1.0, most = 0.0;
  constexpr int places = 4096;
  for (int i = 0; i < places; ++i) {
    const glm::vec3 place(0.25f * static_cast<float>(i), -0.0f, 1.5f);
    const auto at = dfr_at(dfr, 0.5, place_bits(place));
    EXPECT_EQ(at, dfr_at(dfr, 0.5, place_bits({place.x, 0.0f, place.z}))) << "the same place";
    const double factor = at[0] / dfr_at(dfr.rgb[0], 0.5);
    EXPECT_NEAR(at[1], factor * dfr_at(dfr.rgb[1], 0.5), 1e-12)
        << "all colours are perturbed alike";
    EXPECT_LE(at[2], 1.0);
    sum += factor;
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  // Five standard deviations of the mean of uniform numbers. With so many points the extremes are
  // close.
  EXPECT_NEAR(sum / places, 1.0, 5.0 * 0.3 / std::sqrt(3.0 * places));
  EXPECT_GE(least, 0.7);
  EXPECT_LT(least, 0.71);
  EXPECT_LE(most, 1.3);
  EXPECT_GT(most, 1.29);
}

TEST(Dfr, WithoutPerturbationIsTheCurves) {
  const Dfr dfr{{{{0.4, 0.8, 2.0}, {0.5, 0.8, 3.0}, {0.9, 1.0, 4.0}}}, 0.0};
  const auto at = dfr_at(dfr, 0.5, place_bits({1, 2, 3}));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(at[k], dfr_at(dfr.rgb[k], 0.5));
}

/// Tangent of the angle to the mirrored direction that contains half of the light of a parallel
/// beam, for a GGX surface at normal incidence.
double median_tangent(float roughness) {
  constexpr int steps = 200000;
  const auto energy = [&](double angle) {
    const double half = 0.5 * angle;
    BrdfAngles a;
    a.n_dot_l = static_cast<float>(std::cos(angle));
    a.n_dot_v = 1.0f;
    a.n_dot_h = static_cast<float>(std::cos(half));
    a.v_dot_h = a.n_dot_h;
    return static_cast<double>(ggx_lobe(roughness, a) * a.n_dot_l) * std::sin(angle);
  };
  constexpr double step = 0.5 * std::numbers::pi / steps;
  double all = 0.0;
  for (int i = 0; i < steps; ++i) all += energy((i + 0.5) * step);
  double sum = 0.0;
  int i = 0;
  for (; sum < 0.5 * all; ++i) sum += energy((i + 0.5) * step);
  return std::tan(i * step);
}

TEST(LobeWidth, HoldsHalfOfTheLightWhereAGgxLobeDoes) {
  for (float roughness : {0.1f, 0.2f, 0.3f}) {
    // The disk of the square's area has this radius; half of its light is within 1 / sqrt(2) of it.
    const double radius = lobe_width(static_cast<double>(roughness)) / std::sqrt(std::numbers::pi);
    EXPECT_NEAR(radius / std::sqrt(2.0) / median_tangent(roughness), 1.0, 0.02) << roughness;
  }
}

TEST(LobeWidth, IsThatOfAMirrorAtRoughnessZero) {
  EXPECT_EQ(lobe_width(0.0), 0.0);
  EXPECT_NEAR(0.5 * lobe_width(0.2), 2.5 * 0.04, 0.003 * 0.1);
}

}  // namespace
}  // namespace asos
