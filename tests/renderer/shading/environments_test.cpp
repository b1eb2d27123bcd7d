#include "renderer/shading/environments.h"

#include "renderer/shading/environment.h"
#include "tests/renderer/shading/sky_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos::test::sky_sums {
namespace {

/// The radiance that an environment adds depending on the azimuth.
double added(const AzimuthVariation::Amounts& sides, glm::dvec3 d) {
  const double azimuth = std::atan2(d.x, d.z), level = std::hypot(d.x, d.z);
  const auto rad = [](double deg) { return deg * std::numbers::pi / 180.0; };
  return sides.one * level * std::cos(azimuth - rad(sides.one_deg)) +
         sides.two * level * level * std::cos(2.0 * (azimuth - rad(sides.two_deg)));
}

// Environments follow a formula linear in the sine of the elevation; irradiances and means
// integrate it.
TEST(Sky, EnvironmentsAreGradientsUpAndDown) {
  for (const EnvironmentRow& row : environments) {
    SCOPED_TRACE(row.name);
    const Sky sky(row.value);
    EXPECT_EQ(sky.name(), row.name);
    if (sky.is_picture()) continue;  // the gradient does not describe it
    const Gradient::Colours& of = row.colours;
    EXPECT_EQ(sky.radiance({0, 1, 0}), of.zenith);
    for (int k = 0; k < 3; ++k)
      EXPECT_FLOAT_EQ(
          sky.radiance({0, 0, -1})[k],
          0.5f * (of.above[k] + of.below[k]) + static_cast<float>(added(row.sides, {0, 0, -1})));
    EXPECT_EQ(sky.radiance({0, -1, 0}), of.nadir);
    const Radiance radiance = [&](glm::dvec3 d) {
      const double over = std::clamp(0.5 + 0.5 * d.y / Gradient::ramp, 0.0, 1.0);
      const glm::dvec3 above(of.above), below(of.below);
      const glm::dvec3 end(d.y > 0.0 ? of.zenith : of.nadir);
      const glm::dvec3 from(d.y > 0.0 ? of.above : of.below);
      return (glm::mix(below, above, over) + std::abs(d.y) * (end - from)).g + added(row.sides, d);
    };
    for (const glm::vec3 n : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(0.6f, 0.8f, 0),
                              glm::vec3(0, -0.28f, 0.96f)})
      EXPECT_NEAR(static_cast<double>(sky.ambient(n).g / sky_visibility), irradiance(radiance, n),
                  1e-4);
    for (int i = 0; i < 32; ++i) {
      const Patch3 p = random_patch(i, 0.4);
      EXPECT_NEAR(mean_of(sky, p), brute_force(radiance, p), 0.005);
    }
    // Patches of a pixel's size, half of them moved towards the horizon: errors are invisible.
    for (int i = 0; i < 200; ++i) {
      Patch3 p = random_patch(i, 0.004);
      if (i % 2) p.direction = glm::normalize(p.direction * glm::vec3(1.0f, 0.1f, 1.0f));
      EXPECT_NEAR(mean_of(sky, p), brute_force(radiance, p), 1e-5) << i;
    }
    // Lobes.
    for (int i = 0; i < 200; ++i) {
      Patch3 p = random_patch(i, 1.0);
      const float width = 0.02f * static_cast<float>(i);
      p.right = width * glm::normalize(p.right);
      p.down = width * glm::normalize(p.down);
      EXPECT_NEAR(static_cast<double>(sky.around(p.direction, roughness_of(width)).g),
                  brute_force(radiance, p), 0.02)
          << i;
    }
  }
}

// A polished cube shows bright and dark parts in any orientation; matte surfaces get about as much
// light as in the studio.
TEST(Sky, EnvironmentsWithPanelsShowInMirrorsAllAround) {
  for (const Environment environment : {Environment::softboxes, Environment::windows}) {
    const Sky sky(environment);
    ASSERT_TRUE(sky.is_picture());
    for (int face_deg = 0; face_deg < 360; face_deg += 15) {
      float least = 1e9f, most = 0.0f;
      for (int off = -60; off <= 60; off += 2) {
        for (int up = -20; up <= 40; up += 2) {
          const double a = (face_deg + off) * std::numbers::pi / 180.0;
          const double e = up * std::numbers::pi / 180.0;
          const float g =
              sky.radiance({std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}).g;
          least = std::min(least, g);
          most = std::max(most, g);
        }
      }
      EXPECT_GT(most, 4.0f * least) << face_deg;
      EXPECT_GT(most, 1.0f) << face_deg;
    }
    const float up = sky.ambient({0, 1, 0}).g / 0.6f;
    EXPECT_GT(up, 0.4f);
    EXPECT_LT(up, 0.9f);
  }
}

TEST(Sky, EnvironmentsAreTurnedAndBrightened) {
  for (const EnvironmentRow& row : environments) {
    SCOPED_TRACE(row.name);
    const Sky sky(row.value), placed = sky.turned(90.0).brightened(3.0);
    EXPECT_EQ(placed.choice().turn_deg, 90.0);
    EXPECT_EQ(placed.choice().brightness, 3.0);
    for (int i = 0; i < 40; ++i) {
      const Patch3 p = random_patch(i, 0.5);
      // Counter-clockwise seen from above: +Z goes to +X.
      const auto turned = [](glm::vec3 v) { return glm::vec3(v.z, v.y, -v.x); };
      const float before = sky.radiance(p.direction, p.right, p.down).g;
      const float after = placed.radiance(turned(p.direction), turned(p.right), turned(p.down)).g;
      EXPECT_NEAR(after, 3.0f * before, 1e-4f * (1.0f + before)) << i;
      EXPECT_NEAR(placed.ambient(turned(p.direction)).g, 3.0f * sky.ambient(p.direction).g, 1e-4f);
    }
    const Sky back = placed.turned(0.0).brightened(1.0);
    EXPECT_EQ(back.choice(), sky.choice());
    EXPECT_EQ(back.radiance({0.6f, 0.48f, 0.64f}), sky.radiance({0.6f, 0.48f, 0.64f}));
    const auto made = make_sky(placed.choice());
    ASSERT_TRUE(made);
    EXPECT_EQ((*made)->radiance({0.6f, 0.48f, 0.64f}), placed.radiance({0.6f, 0.48f, 0.64f}));
  }
}

// A vertical mirror that faces a viewer who looks roughly along -Z is visible by its brightness; no
// part of the sky is black.
TEST(Sky, AStudioShowsInVerticalMirrors) {
  const Sky sky(Environment::studio);
  const auto at = [](double azimuth_deg, double height) {
    const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
    const double level = std::sqrt(1.0 - height * height);
    return glm::dvec3(level * std::sin(azimuth), height, level * std::cos(azimuth));
  };
  const auto radiance = [&](glm::dvec3 d) {
    return static_cast<double>(sky.radiance(glm::vec3(d)).g);
  };
  for (double looks = 160.0; looks <= 215.0; looks += 5.0) {
    for (double faces = looks - 230.0; faces <= looks - 130.0; faces += 5.0) {
      for (const double height : {-0.3, 0.0, 0.2}) {
        const glm::dvec3 d = at(looks, height);
        EXPECT_GT(radiance(glm::reflect(d, at(faces, 0.0))), radiance(d) + 0.035)
            << looks << " " << faces;
      }
    }
  }
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 5.0)
    for (const double height : {-0.99, -0.7, -0.3, 0.0, 0.3})
      EXPECT_GT(radiance(at(azimuth, height)), 0.1);
}

}  // namespace
}  // namespace asos::test::sky_sums
