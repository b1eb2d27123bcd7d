#include "renderer/shading/ltc.h"

#include "renderer/shading/brdf.h"
#include "renderer/shading/ltc_table.h"
#include "renderer/shading/viewed_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// The fitted lobes against the BRDF, direction by direction.

namespace asos::ltc_test {
namespace {

using std::numbers::pi;

/// What interpolating the table may add.
constexpr double interpolated = 0.01;
constexpr glm::dvec3 up(0.0, 0.0, 1.0);

glm::dvec3 viewer_at(double cosine) {
  return {-std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

/// The lobe times the cosine, and that times Schlick's (1 - v.h)^5, in double precision.
struct Values {
  double lobe = 0.0;
  double fresnel = 0.0;
};

Values values_of(glm::dvec3 v, glm::dvec3 l, double roughness) {
  const glm::dvec3 h = glm::normalize(v + l);
  const double a2 = std::pow(roughness, 4.0);
  const double b = h.x * h.x + h.y * h.y + a2 * h.z * h.z;
  const auto root = [a2](double x) { return std::sqrt(a2 + (1.0 - a2) * x * x); };
  const double visibility = 0.5 / (l.z * root(v.z) + v.z * root(l.z));
  const double lobe = a2 / (pi * b * b) * visibility * l.z;
  return {lobe, lobe * std::pow(1.0 - glm::dot(v, h), 5.0)};
}

double fitted(const Ltc& ltc, glm::dvec3 l) {
  const glm::dvec3 p = ltc.to_cosine * l;
  const double length2 = glm::dot(p, p);
  const double determinant = std::abs(glm::determinant(ltc.to_cosine));
  return std::max(0.0, p.z) / (length2 * length2) * determinant * ltc.weight;
}

struct Compared {
  Values norm;       ///< the BRDF's own integrals
  Values fit;        ///< the fit's
  Values different;  ///< half the integral of the difference
};

/// Numbers from `low` to `high` and what each stands for, the finer the nearer to `middle`: sinh of
/// equal steps.
struct Steps {
  Steps(double low, double high, double middle, double width, int count) {
    const double begin = std::asinh((low - middle) / width);
    const double step = (std::asinh((high - middle) / width) - begin) / count;
    for (int i = 0; i < count; ++i) {
      const double t = begin + (i + 0.5) * step;
      at.push_back(middle + width * std::sinh(t));
      weight.push_back(width * std::cosh(t) * step);
    }
  }
  std::vector<double> at, weight;
};

/// Over half of the upper hemisphere, by elevation and azimuth: the other half is the same. A lobe
/// seen at a grazing angle is narrow about the whole plane of view.
Compared compare(double cosine, double roughness) {
  const double alpha = roughness * roughness;
  const glm::dvec3 v = viewer_at(cosine);
  const LtcPair pair = ltc_of({glm::dvec3(0.0), up, up}, v, roughness);
  const Steps elevations(0.0, 0.5 * pi, std::asin(cosine), alpha * (0.1 + 0.9 * cosine), 400);
  const Steps azimuths(0.0, 0.5 * pi, 0.0, alpha * std::max(alpha, 0.5 * cosine), 150);
  Compared all;
  for (std::size_t i = 0; i < elevations.at.size(); ++i) {
    const double height = std::sin(elevations.at[i]);
    const double across = std::cos(elevations.at[i]);
    for (std::size_t k = 0; k < 2 * azimuths.at.size(); ++k) {
      const double forward = across * std::cos(azimuths.at[k / 2]);
      const glm::dvec3 l(k % 2 ? -forward : forward, across * std::sin(azimuths.at[k / 2]), height);
      const double weight = 2.0 * across * elevations.weight[i] * azimuths.weight[k / 2];
      const Values value = values_of(v, l, roughness);
      const Values fit{fitted(pair.lobe, l), fitted(pair.fresnel, l)};
      all.norm.lobe += weight * value.lobe;
      all.norm.fresnel += weight * value.fresnel;
      all.fit.lobe += weight * fit.lobe;
      all.fit.fresnel += weight * fit.fresnel;
      all.different.lobe += 0.5 * weight * std::abs(value.lobe - fit.lobe);
      all.different.fresnel += 0.5 * weight * std::abs(value.fresnel - fit.fresnel);
    }
  }
  return all;
}

/// Neither a place of the table nor in the middle between.
constexpr double kRoughnesses[] = {0.1, 0.145, 0.23, 0.31, 0.45, 0.61, 0.83, 1.0};
constexpr double kCosines[] = {0.02, 0.09, 0.18, 0.35, 0.52, 0.77, 0.95, 1.0};

TEST(Ltc, GivesTheLobesIntegralsAndPromisedErrors) {
  for (const double roughness : kRoughnesses) {
    for (const double cosine : kCosines) {
      const Compared all = compare(cosine, roughness);
      const LtcNorms norms = ltc_norms(cosine, roughness);
      const LtcError error = ltc_error(cosine, roughness);
      const std::string at =
          "roughness " + std::to_string(roughness) + ", n.v " + std::to_string(cosine);
      EXPECT_NEAR(norms.lobe, all.norm.lobe, interpolated * all.norm.lobe) << at;
      EXPECT_NEAR(all.fit.lobe, norms.lobe, interpolated * norms.lobe) << at;
      // What a dielectric mirrors: Schlick's part is next to nothing near to the normal.
      const double dielectric = 0.04 * all.norm.lobe + all.norm.fresnel;
      EXPECT_NEAR(all.fit.fresnel, norms.fresnel, interpolated * dielectric) << at;
      EXPECT_NEAR(norms.fresnel, all.norm.fresnel, interpolated * dielectric) << at;
      EXPECT_LT(all.different.lobe, (error.lobe + interpolated) * all.norm.lobe) << at;
      EXPECT_LT(all.different.fresnel, error.fresnel * all.norm.fresnel + interpolated * dielectric)
          << at;
    }
  }
}

TEST(Ltc, IsBrdfsOwnLobe) {
  const glm::dvec3 v = viewer_at(0.6);
  for (const double roughness : {0.2, 0.45, 0.9}) {
    const glm::dvec3 l = glm::normalize(glm::dvec3(0.5, 0.3, 0.7));
    const glm::dvec3 h = glm::normalize(v + l);
    const BrdfAngles angles{static_cast<float>(l.z), static_cast<float>(v.z),
                            static_cast<float>(h.z), static_cast<float>(glm::dot(v, h))};
    const double own = static_cast<double>(ggx_lobe(static_cast<float>(roughness), angles)) * l.z;
    EXPECT_NEAR(values_of(v, l, roughness).lobe, own, 1e-4 * own) << roughness;
  }
}

TEST(Ltc, MeetsTheLobeExactlySeenFromAboveAndSmooth) {
  const glm::dvec3 v = viewer_at(1.0);
  const LtcPair pair = ltc_of({glm::dvec3(0.0), up, up}, v, 0.1);
  const double peak = values_of(v, up, 0.1).lobe;
  for (const double angle : {0.0, 0.005, 0.01, 0.03, 0.1}) {
    const glm::dvec3 l(std::sin(angle), 0.0, std::cos(angle));
    EXPECT_NEAR(fitted(pair.lobe, l), values_of(v, l, 0.1).lobe, 2e-3 * peak) << angle;
  }
}

TEST(Ltc, IsFiniteAndChangesBySmallSteps) {
  const auto response = [](double cosine, double roughness) {
    const LtcPair pair = ltc_of({glm::dvec3(0.0), up, up}, viewer_at(cosine), roughness);
    return Values{pair.lobe.weight * whole_form(pair.lobe.horizons),
                  pair.fresnel.weight * whole_form(pair.fresnel.horizons)};
  };
  double last = response(0.0, 0.1).lobe;
  for (int i = 1; i <= 5000; ++i) {
    const double x = i / 5000.0;
    const Values all = response(x, 0.1 + 0.9 * x);
    ASSERT_TRUE(std::isfinite(all.lobe) && std::isfinite(all.fresnel)) << x;
    EXPECT_GT(all.lobe, 0.0) << x;
    EXPECT_GE(all.fresnel, 0.0) << x;
    EXPECT_LE(all.lobe, 1.0 + 1e-3) << x;
    EXPECT_LT(std::abs(all.lobe - last), 0.01) << x;
    last = all.lobe;
  }
  for (const double cosine : {-1.0, -0.2, 0.0, 1e-9, 1.0}) {
    for (const double roughness : {-1.0, 0.0, 0.1, 1.0, 5.0}) {
      const Receiver receiver{glm::dvec3(0.0), up, up};
      const LtcPair pair = ltc_of(receiver, viewer_at(cosine), roughness);
      EXPECT_TRUE(std::isfinite(pair.lobe.weight)) << cosine << " " << roughness;
      EXPECT_TRUE(std::isfinite(glm::determinant(pair.fresnel.to_cosine)));
      EXPECT_GT(glm::determinant(pair.lobe.to_cosine), 0.0) << cosine << " " << roughness;
    }
  }
}

// The horizons of a surface whose shading normal is not its own keep what lies above both.
TEST(Ltc, TransformsHorizonsWithTheLight) {
  const glm::dvec3 geometric = glm::normalize(glm::dvec3(0.3, -0.4, 0.9));
  for (const double cosine : {0.05, 0.4, 0.9}) {
    const LtcPair pair = ltc_of({glm::dvec3(0.0), up, geometric}, viewer_at(cosine), 0.4);
    for (const Ltc& ltc : {pair.lobe, pair.fresnel}) {
      for (const glm::dvec3& l : {glm::dvec3(0.9, 0.1, 0.2), glm::dvec3(-0.9, 0.3, 0.1),
                                  glm::dvec3(0.1, 0.9, -0.1), glm::dvec3(0.2, 0.8, 0.3)}) {
        const bool above = l.z > 0.0 && glm::dot(l, geometric) > 0.0;
        bool kept = true;
        for (std::size_t i = 1; i < ltc.horizons.normals().size(); ++i)
          kept &= glm::dot(ltc.horizons.normals()[i], ltc.to_cosine * l) > 0.0;
        EXPECT_EQ(kept, above) << cosine;
      }
    }
  }
}

TEST(LtcTable, IsWithinItsLimits) {
  for (const LtcTable* table : {&ltc_of_lobe, &ltc_of_fresnel}) {
    for (const LtcEntry& entry : *table) {
      EXPECT_GT(entry.width, 0.0f);
      EXPECT_GT(entry.stretch, 0.0f);
      EXPECT_GT(entry.norm, 0.0f);
      EXPECT_LE(entry.norm, 1.0f);
      EXPECT_TRUE(std::isfinite(entry.tilt) && std::isfinite(entry.lean));
    }
  }
}

}  // namespace
}  // namespace asos::ltc_test
