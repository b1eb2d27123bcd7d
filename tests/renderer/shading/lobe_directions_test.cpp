#include "renderer/shading/lobe_directions.h"

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/viewed_point.h"
#include "tests/support/facets.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace asos::test::lobe_directions_test {
namespace {

constexpr std::uint32_t samples = 1 << 14;
constexpr int rings = 700;

/// A surface with normal z, seen at an angle in an oblique vertical plane.
struct Seen {
  Seen(double angle, float roughness)
      : to_viewer(0.8 * std::sin(angle), 0.6 * std::sin(angle), std::cos(angle)) {
    own.f0 = glm::vec3(0.04f, 0.5f, 1.0f);
    own.roughness = roughness;
    facets.alpha = glm::dvec2(static_cast<double>(roughness) * static_cast<double>(roughness));
  }
  [[nodiscard]] LobeDirections lobe(float spread = 0.0f) const {
    return {own, spread, {0, 0, 1}, glm::vec3(to_viewer)};
  }

  Lobe own;
  Facets facets;
  glm::dvec3 to_viewer;
};

/// Mean over the lobe of a function of the light's direction.
template <typename Function>
glm::dvec3 mean(const LobeDirections& lobe, const Function& radiance) {
  const SobolPixel places(3, 5, 7);
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < samples; ++i)
    if (const auto found = lobe.mirrored(places.lobe(i, SampleStream::reflections)))
      sum += glm::dvec3(found->weight) * radiance(glm::dvec3(found->unit));
  return sum / static_cast<double>(samples);
}

/// Surroundings that differ in all directions.
double surroundings(glm::dvec3 l) {
  return 0.5 + 0.3 * std::sin(7.0 * l.x) + 0.2 * std::cos(5.0 * l.y);
}

void expect_facets(Seen seen, const LobeDirections& lobe) {
  for (const bool even : {true, false}) {
    const auto radiance = [even](glm::dvec3 l) { return even ? 1.0 : surroundings(l); };
    const glm::dvec3 found = mean(lobe, radiance);
    for (int c = 0; c < 3; ++c) {
      seen.facets.f0 = static_cast<double>(seen.own.f0[c]);
      const double expected = seen.facets.mirrored(rings, seen.to_viewer, radiance);
      EXPECT_NEAR(found[c], expected, 1e-3 * expected)
          << "roughness " << seen.own.roughness << ", cosine " << seen.to_viewer.z << ", colour "
          << c << (even ? ", even" : "");
    }
  }
}

class EveryLobe : public testing::TestWithParam<std::tuple<float, double>> {};

TEST_P(EveryLobe, MirrorsAsItsFacetsDo) {
  const auto [roughness, angle] = GetParam();
  const Seen seen(angle, roughness);
  expect_facets(seen, seen.lobe());
}

INSTANTIATE_TEST_SUITE_P(Roughness, EveryLobe,
                         testing::Combine(testing::Values(0.05f, 0.1f, 0.2f, 0.35f, 0.7f, 1.0f),
                                          testing::Values(0.0, 0.6, 1.2, 1.45)));

TEST(LobeDirections, AreDrawnOutAsTheLobeIs) {
  for (const double angle : {0.0, 0.9, 1.3}) {
    Seen seen(angle, 0.25f);
    seen.facets.alpha.x = 0.3;
    const double across = seen.facets.alpha.y;
    seen.own.stretch.along = {
        static_cast<float>(std::sqrt(seen.facets.alpha.x * seen.facets.alpha.x - across * across)),
        0.0f, 0.0f};
    expect_facets(seen, seen.lobe());
  }
}

// The squared slopes of facets and bumps add up.
TEST(LobeDirections, AreSpreadByBumpsAsWell) {
  Seen seen(0.7, 0.2f);
  const LobeDirections lobe = seen.lobe(0.01f);
  seen.facets.alpha = glm::dvec2(std::sqrt(0.04 * 0.04 + 0.01));
  expect_facets(seen, lobe);
}

TEST(LobeDirections, RefractBySnellsLawAtEachFacet) {
  for (const float ratio : {1.0f / 1.5f, 1.5f}) {
    for (const double angle : {0.0, 0.5}) {
      const Seen seen(angle, 0.3f);
      const LobeDirections lobe = seen.lobe();
      const SobolPixel places(3, 5, 7);
      glm::dvec3 sum(0.0);
      std::uint32_t none = 0;
      for (std::uint32_t i = 0; i < samples; ++i) {
        const auto found = lobe.refracted(places.lobe(i, SampleStream::reflections), ratio);
        if (found) {
          EXPECT_NEAR(glm::length(*found), 1.0f, 1e-5f);
          sum += glm::dvec3(*found);
        } else {
          ++none;
        }
      }
      const auto snell = [&](glm::dvec3 h) {
        const glm::dvec3 l = glm::refract(-seen.to_viewer, h, static_cast<double>(ratio));
        return l.z < 0.0 ? l : glm::dvec3(0.0);
      };
      const auto lost = [&](glm::dvec3 h) { return snell(h) == glm::dvec3(0.0) ? 1.0 : 0.0; };
      const glm::dvec3 expected = seen.facets.over_visible(rings, seen.to_viewer, snell);
      EXPECT_LT(glm::length(sum / double{samples} - expected), 1e-3) << ratio << ' ' << angle;
      EXPECT_NEAR(none / double{samples}, seen.facets.over_visible(rings, seen.to_viewer, lost),
                  2e-3)
          << ratio << ' ' << angle;
    }
  }
}

TEST(LobeDirections, GoThroughThinWallsAsTheyAreMirrored) {
  const Seen seen(0.6, 0.3f);
  const LobeDirections lobe = seen.lobe();
  const SobolPixel places(3, 5, 7);
  int above = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto mirrored = lobe.mirrored(places.lobe(i, SampleStream::reflections));
    const auto through = lobe.refracted(places.lobe(i, SampleStream::reflections), 1.0f);
    ASSERT_TRUE(through);
    EXPECT_LT(through->z, 0.0f) << "no direction is lost";
    if (!mirrored) continue;
    ++above;
    EXPECT_LT(glm::distance(*through, mirrored->unit * glm::vec3(1, 1, -1)), 1e-6f);
  }
  EXPECT_GT(above, 56);
}

// A normal map may tilt the normal away from the viewer; the reflected direction is above the
// surface all the same.
TEST(MirroringNormal, MirrorsAboveTheSurface) {
  SurfacePoint point;
  point.geometric_normal = {0, 1, 0};
  int bent = 0;
  for (double tilt = -0.6; tilt <= 0.6; tilt += 0.1) {
    point.shading_normal =
        glm::vec3(static_cast<float>(std::sin(tilt)), static_cast<float>(std::cos(tilt)), 0.0f);
    for (double angle = 0.0; angle < 1.55; angle += 0.1) {
      const glm::vec3 viewer(static_cast<float>(std::sin(angle)),
                             static_cast<float>(std::cos(angle)), 0.0f);
      const glm::vec3 normal = mirroring_normal(point, viewer);
      const glm::vec3 mirrored = glm::reflect(-viewer, normal);
      EXPECT_GE(mirrored.y, 0.9f * least_mirrored_rise) << tilt << ' ' << angle;
      EXPECT_NEAR(mirroring_cosine(viewed_point(point, viewer)),
                  std::max(glm::dot(normal, viewer), grazing_cosine), 1e-3f);
      bent += normal != point.shading_normal;
    }
  }
  EXPECT_GT(bent, 20);
}

TEST(LobeDirections, AreUnitForAViewerBelowTheNormal) {
  const glm::vec3 viewer = glm::normalize(glm::vec3(1.0f, 0.0f, -0.3f));
  const LobeDirections lobe(white_lobe(0.3), 0.0f, {0, 0, 1}, viewer);
  for (int i = 0; i < 64; ++i) {
    const auto found = lobe.mirrored({(i + 0.5) / 64.0, 0.3});
    if (found) {
      EXPECT_NEAR(glm::length(found->unit), 1.0f, 1e-5f);
    }
  }
}

}  // namespace
}  // namespace asos::test::lobe_directions_test
