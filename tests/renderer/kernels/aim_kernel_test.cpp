#include "renderer/kernels/aim_kernel.h"

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shading/shadow_ray.h"
#include "tests/support/every_target.h"
#include "tests/support/lit_subjects.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

// Vectorised generation of rays to lights against the scalar double-precision functions, and their
// weights against closed forms of whole lights.

namespace asos::test::aim_kernel_test {
namespace {

/// A point of a light, by area if it is flat, and its light per unit of power.
LightSample place_on(const PreparedLight& light, const Receiver& receiver, glm::dvec2 at) {
  if (light.shape != LightShape::rectangle) return sample_light(light, receiver, at.x, at.y);
  const glm::dvec3 to = light.position - receiver.position + (2.0 * at.x - 1.0) * light.half_u +
                        (2.0 * at.y - 1.0) * light.half_v;
  LightSample sample{.distance = glm::length(to)};
  sample.direction = to / sample.distance;
  const double height = -glm::dot(to, light.towards);
  const double cosine = glm::dot(sample.direction, receiver.normal);
  if (!light.faces(height) || !(cosine > 0.0) ||
      !(glm::dot(sample.direction, receiver.geometric) > 0.0))
    return sample;
  const double form = light.area * std::abs(height) * cosine /
                      (sample.distance * sample.distance * sample.distance);
  sample.irradiance = light.power * static_cast<float>(form);
  return sample;
}

glm::vec3 at(const std::array<ShadowRayBatch::Floats, 3>& v, std::size_t i) {
  return {v[0][i], v[1][i], v[2][i]};
}

float largest(glm::vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

class AimKernel : public testing::TestWithParam<RayWeighting> {};

TEST_P(AimKernel, RaysMatchTheScalarFunctions) {
  const bool by_radiance = GetParam() == RayWeighting::radiance;
  for (const auto& [scale, offset] : scales) {
    const LitSubjects batch(static_cast<std::uint64_t>(std::log10(scale) + 60.0), scale, offset);
    for (const NamedLight& named : lights(scale, offset)) {
      const PreparedLight& light = named.prepared;
      if (by_radiance && light.rule == LightRule::published) continue;
      // Inside a sphere light, light ends abruptly at the horizon, and rounding decides on which
      // side a direction is.
      if (named.name == "huge ball") continue;
      SCOPED_TRACE(named.name + " at scale " + std::to_string(std::log10(scale)));
      ShadowRayBatch rays;
      aim_batch(batch.points, LightConstants(light), batch.places, GetParam(), rays);
      std::vector<double> expected;
      std::vector<Ray> ways;
      double mean = 0.0;
      for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
        const LitSubject& s = batch.subjects[i];
        const LightSample sample = place_on(light, receiver_at(*s.point), batch.at(i));
        const LightingQuery lit = s.lit();
        const glm::vec3 carried =
            reflected_from({light, 0, *s.point, {}, {}, 0, &lit}, sample) * sample.irradiance;
        expected.push_back(by_radiance
                               ? static_cast<double>(carried.x + carried.y + carried.z) / 3.0
                               : static_cast<double>(sample.irradiance.x / light.power.x));
        ways.push_back(shadow_ray(*s.point, sample));
        mean += expected.back() / static_cast<double>(batch.subjects.size());
      }
      ASSERT_GT(mean, 0.0);
      // The rays belong to the lit points, in order.
      std::size_t next = 0;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        SCOPED_TRACE("point " + std::to_string(i));
        const double tolerance = 2e-4 * expected[i] + 1e-5 * mean;
        if (expected[i] <= tolerance) {
          const bool sent = next < rays.count &&
                            largest(at(rays.direction, next) - ways[i].direction) < 2e-5f &&
                            static_cast<double>(rays.carried[0][next]) <= 2.0 * tolerance;
          next += sent;
          continue;
        }
        ASSERT_LT(next, rays.count);
        EXPECT_NEAR(static_cast<double>(rays.carried[0][next]), expected[i], tolerance);
        EXPECT_LT(largest(at(rays.direction, next) - ways[i].direction), 2e-5f);
        EXPECT_LE(largest(at(rays.origin, next) - ways[i].origin), 2e-7f * largest(ways[i].origin));
        if (std::isfinite(ways[i].t_far)) {
          EXPECT_NEAR(rays.t_far[next] / ways[i].t_far, 1.0, 2e-3);
        }
        ++next;
      }
      EXPECT_EQ(next, rays.count);
    }
  }
}

TEST_P(AimKernel, AllInstructionSetsGiveTheSameBits) {
  std::vector<std::uint32_t> first;
  for_every_target([&] {
    std::vector<std::uint32_t> bits;
    for (const auto& [scale, offset] : scales) {
      const LitSubjects batch(99, scale, offset);
      for (const NamedLight& light : lights(scale, offset)) {
        ShadowRayBatch rays;
        aim_batch(batch.points, LightConstants(light.prepared), batch.places, GetParam(), rays);
        for (std::size_t i = 0; i < rays.count; ++i) {
          bits.push_back(std::bit_cast<std::uint32_t>(rays.carried[0][i]));
          bits.push_back(std::bit_cast<std::uint32_t>(rays.t_far[i]));
          for (std::size_t k = 0; k < 3; ++k) {
            bits.push_back(std::bit_cast<std::uint32_t>(rays.origin[k][i]));
            bits.push_back(std::bit_cast<std::uint32_t>(rays.direction[k][i]));
          }
        }
      }
    }
    if (first.empty()) first = bits;
    EXPECT_GT(bits.size(), 1000u);
    EXPECT_EQ(first, bits);
  });
}

INSTANTIATE_TEST_SUITE_P(By, AimKernel,
                         testing::Values(RayWeighting::irradiance, RayWeighting::radiance),
                         [](const auto& by) {
                           return by.param == RayWeighting::radiance ? "Radiance" : "Irradiance";
                         });

// Batches are reused between pictures, so old contents must not matter.
TEST(RepeatedPoint, HasNoSheenThatAnotherHad) {
  const auto& [scale, offset] = scales[0];
  const LitSubjects subjects(7, scale, offset);
  ShadingPoints used;
  int without = 0;
  for (const LitSubject& subject : subjects.subjects) {
    const LightingQuery lit = subject.lit();
    if (lit.material.lobe.is_sheen()) continue;
    used.sheen.fill(0.5f);
    used.count = 0;
    used.add(lit, glm::vec3(1.0f));
    used.repeat_first(9, true);
    EXPECT_EQ(std::count(used.sheen.begin(), used.sheen.begin() + 9, 0.0f), 9);
    ++without;
  }
  EXPECT_GT(without, 10);
}

// The mean is the closed form of the light (Lambert's sum; the view factor for spheres and disks).
TEST(AimedRays, HaveTheLightsIrradianceAsTheirMean) {
  SurfacePoint point{.position = {0.7f, 0.0f, 0.2f}};
  point.shading_normal = point.geometric_normal = {0, 1, 0};
  for (const NamedLight& named : lights(1.0, {0, 0, 0})) {
    const PreparedLight& light = named.prepared;
    if (light.shape == LightShape::segment) continue;  // by length, not evenly
    SCOPED_TRACE(named.name);
    const LightConstants constants(light);
    constexpr std::uint32_t rounds = 64;
    double sum = 0.0;
    for (std::uint32_t round = 0; round < rounds; ++round) {
      ShadingPoints points;
      LightPointBatch places;
      points.add(point);
      points.repeat_first(ShadingPoints::size, false);
      for (std::uint32_t i = 0; i < ShadingPoints::size; ++i) {
        const auto index = round * static_cast<std::uint32_t>(ShadingPoints::size) + i;
        places.u[i] = owen_scramble(sobol_bits(SobolDimension::pixel_x, index), 1);
        places.v[i] = owen_scramble(sobol_bits(SobolDimension::pixel_y, index), 2);
      }
      ShadowRayBatch rays;
      aim_batch(points, constants, places, RayWeighting::irradiance, rays);
      for (std::size_t i = 0; i < rays.count; ++i) sum += static_cast<double>(rays.carried[0][i]);
    }
    const double exact =
        static_cast<double>(unshadowed_irradiance(light, receiver_at(point)).x / light.power.x);
    ASSERT_GT(exact, 0.0);
    EXPECT_NEAR(sum / (rounds * ShadingPoints::size), exact, 1e-3 * exact);
  }
}

}  // namespace
}  // namespace asos::test::aim_kernel_test
