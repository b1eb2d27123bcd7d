#include "renderer/kernels/light_kernel.h"

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shading/shadow_ray.h"
#include "tests/support/every_target.h"
#include "tests/support/lit_subjects.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// The kernels against the scalar double-precision functions.

namespace asos::test::light_kernel_test {
namespace {

struct Expected {
  LightSample sample;
  Ray ray;
  glm::vec3 carried;
  glm::vec3 unshadowed;
};

/// Density of reflected visible normals (Heitz 2018), by solid angle.
double lobe_density(const LitSubject& s, glm::dvec3 l) {
  const glm::dvec3 n(s.point->shading_normal), v(s.view->to_viewer);
  const double a2 = std::pow(static_cast<double>(s.material.lobe.roughness), 4.0);
  const double nv = glm::dot(n, v), nh = glm::dot(n, glm::normalize(v + l));
  const double d = nh * nh * (a2 - 1.0) + 1.0;
  const double masked = 2.0 * nv / (nv + std::sqrt(a2 + (1.0 - a2) * nv * nv));
  return a2 / (std::numbers::pi * d * d) * masked / (4.0 * nv);
}

/// Weight of a light sample for its highlight; samples of the lobe have the rest (balance
/// heuristic).
double share_of_light(const PreparedLight& light, const LitSubject& s, const LightSample& sample) {
  const glm::dvec3 n(s.point->shading_normal);
  const bool area = light.extended() && light.shape != LightShape::segment;
  const bool narrow =
      !s.material.lobe.is_broad() && glm::dot(n, glm::dvec3(s.view->to_viewer)) > 1.0 / 512.0;
  const double form = static_cast<double>(sample.irradiance.x) / static_cast<double>(light.power.x);
  if (!area || !narrow || shows(s.mirrored, light) || !(form > 0.0)) return 1.0;
  const double density = glm::dot(n, sample.direction) / form;
  return density / (density + lobe_density(s, sample.direction));
}

Expected expected(const PreparedLight& light, const LitSubject& s, glm::dvec2 at) {
  const Receiver receiver = receiver_at(*s.point);
  Expected e;
  e.sample = sample_light(light, receiver, at.x, at.y);
  e.ray = shadow_ray(*s.point, e.sample);
  const LightingQuery lit = s.lit();
  const glm::vec3 all = unshadowed_irradiance(light, receiver);
  const glm::vec3 whole = ReflectedLights(lit).of(light, all).reflected;
  glm::vec3 reflected = reflected_from({light, 0, *s.point, {}, whole, 0, &lit}, e.sample);
  const glm::vec3 scattered = s.share * diffuse_brdf(s.material, 0.0f);
  if (light.rule == LightRule::physical) {
    const glm::vec3 l(e.sample.direction);
    const glm::vec3 diffuse =
        s.share * diffuse_brdf(s.material, schlick_weight(s.view->to_viewer, l));
    reflected =
        diffuse + static_cast<float>(share_of_light(light, s, e.sample)) * (reflected - diffuse);
  }
  e.carried = reflected * e.sample.irradiance;
  e.unshadowed = scattered * all + (reflected - scattered) * e.sample.irradiance;
  return e;
}

float largest(glm::vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

glm::vec3 at(const std::array<ShadowRayBatch::Floats, 3>& v, std::size_t i) {
  return {v[0][i], v[1][i], v[2][i]};
}

// Floats have 24 bits: the error of a few dozen roundings, squared for narrow highlights.
constexpr double relative = 2e-4;
constexpr double typical = 1e-5;
constexpr double direction_error = 2e-5;

TEST(LightKernel, RaysAreTheOnesOfThePointsOneByOne) {
  for (const auto& [scale, offset] : scales) {
    const LitSubjects batch(static_cast<std::uint64_t>(std::log10(scale) + 20.0), scale, offset);
    for (const NamedLight& light : lights(scale, offset)) {
      SCOPED_TRACE(light.name + " at scale " + std::to_string(std::log10(scale)));
      ShadowRayBatch rays;
      shade_batch(batch.points, LightConstants(light.prepared), batch.places, rays);
      EXPECT_EQ(rays.rejected, 0u);
      std::vector<Expected> oracle;
      float bright = 0.0f;
      for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
        oracle.push_back(expected(light.prepared, batch.subjects[i], batch.at(i)));
        bright += largest(oracle.back().carried) / static_cast<float>(batch.subjects.size());
      }
      ASSERT_GT(bright, 0.0f);
      std::size_t next = 0;
      double sum = 0.0;
      for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
        SCOPED_TRACE("point " + std::to_string(i));
        const bool sent = next < rays.count && rays.point[next] == i;
        const glm::vec3 carried = sent ? at(rays.carried, next) : glm::vec3(0.0f);
        const Expected& e = oracle[i];
        const float off = largest(carried - e.carried);
        const double tolerance = relative * static_cast<double>(largest(e.carried)) +
                                 typical * static_cast<double>(bright);
        // Inside a sphere light, light ends abruptly at the horizon, and rounding decides on which
        // side a direction is.
        const glm::dvec3 up(batch.subjects[i].point->geometric_normal);
        const bool stops =
            light.name == "huge ball" && std::abs(glm::dot(e.sample.direction, up)) < 1e-3;
        if (stops) {
          next += sent;
          continue;
        }
        sum += static_cast<double>(off / bright);
        EXPECT_LE(off, tolerance) << "carries " << carried.x << ", not " << e.carried.x;
        if (!sent) continue;
        if (largest(e.carried) > 0.0f) {
          EXPECT_LT(largest(at(rays.direction, next) - e.ray.direction), direction_error);
          const glm::vec3 moved = at(rays.origin, next) - e.ray.origin;
          EXPECT_LE(largest(moved), 2e-7f * largest(e.ray.origin));
          if (std::isfinite(e.ray.t_far)) {
            EXPECT_NEAR(rays.t_far[next] / e.ray.t_far, 1.0, 2e-3);
          } else {
            EXPECT_EQ(rays.t_far[next], e.ray.t_far);
          }
        }
        ++next;
      }
      EXPECT_EQ(next, rays.count) << "indices have to ascend";
      // The mean error is that of rounding.
      EXPECT_LT(sum / static_cast<double>(batch.subjects.size()), 1e-5);
    }
  }
}

/// Mean radiance from all samples of a light and from those of the lobe alone, for a point without
/// a patch seen at 30 degrees.
struct Means {
  double both = 0.0, by_lobe = 0.0;
};
Means means_of(const PreparedLight& light, const LitSubject& s) {
  constexpr int rounds = 256;
  Means means;
  const LightConstants constants(light);
  for (int round = 0; round < rounds; ++round) {
    ShadingPoints points;
    LightPointBatch places;
    for (std::uint32_t i = 0; i < ShadingPoints::size; ++i) {
      const auto index = static_cast<std::uint32_t>(round) * 256u + i;
      points.add(s.lit(), glm::vec3(1.0f));
      places.u[i] = owen_scramble(sobol_bits(SobolDimension::pixel_x, index), 1);
      places.v[i] = owen_scramble(sobol_bits(SobolDimension::pixel_y, index), 2);
    }
    ShadowRayBatch rays;
    shade_batch(points, constants, places, rays);
    for (std::size_t i = 0; i < rays.count; ++i)
      means.both += static_cast<double>(rays.carried[0][i]);
    LobeBatch lobes;
    choose_lobes(points, places, lobes);
    LightArcs arcs;
    shade_lobe(points, constants, lobes, arcs, rays);
    for (std::size_t i = 0; i < rays.count; ++i)
      means.by_lobe += static_cast<double>(rays.carried[0][i]);
  }
  means.both = (means.both + means.by_lobe) / (rounds * ShadingPoints::size);
  means.by_lobe /= rounds * ShadingPoints::size;
  return means;
}

// The samples of the light and of the lobe together have the mean of the rendering equation. The
// lobe is sampled only if it is narrow and the light is no line.
TEST(LightKernel, SamplesOfLightAndLobeTogetherHaveTheMeanOfTheBrdf) {
  for (const float roughness : {0.1f, 0.25f, 0.5f, 0.8f}) {
    LitSubject s;
    s.point->position = {1.0f, 0.0f, 0.2f};
    s.point->shading_normal = s.point->geometric_normal = {0, 1, 0};
    const glm::vec3 to_viewer = glm::normalize(glm::vec3(0.9f, 1.3f, 0.1f));
    s.view = std::make_unique<ViewedPoint>(ViewedPoint{*s.point, to_viewer, to_viewer.y});
    s.material.diffuse = glm::vec3(0.3f);
    s.material.lobe.f0 = glm::vec3(0.7f);
    s.material.falloff = 0.9f;
    s.material.lobe.roughness = roughness;
    const LightingQuery lit = s.lit();
    for (const NamedLight& light : lights(1.0, {0, 0, 0})) {
      const PreparedLight& prepared = light.prepared;
      if (!prepared.extended() || prepared.rule == LightRule::published) continue;
      SCOPED_TRACE(light.name + ' ' + std::to_string(roughness));
      const glm::vec3 irradiance = unshadowed_irradiance(prepared, receiver_at(*s.point));
      const double exact = static_cast<double>(
          (ReflectedLights(lit).of(prepared, irradiance).reflected * irradiance).x);
      const Means found = means_of(prepared, s);
      EXPECT_NEAR(found.both, exact, 2e-3 * exact);
      const bool samples_lobe =
          roughness < least_broad_roughness && prepared.shape != LightShape::segment;
      if (samples_lobe && light.name == "rectangle") {
        EXPECT_GT(found.by_lobe, 0.01 * exact);
      }
      if (!samples_lobe) {
        EXPECT_EQ(found.by_lobe, 0.0);
      }
    }
  }
}

TEST(LightKernel, ClosedFormsAreTheOnesOfThePointsOneByOne) {
  for (const auto& [scale, offset] : scales) {
    const LitSubjects batch(static_cast<std::uint64_t>(std::log10(scale) + 40.0), scale, offset);
    for (const NamedLight& light : lights(scale, offset)) {
      if (light.prepared.shape != LightShape::rectangle) continue;
      SCOPED_TRACE(light.name + " at scale " + std::to_string(std::log10(scale)));
      ShadowRayBatch rays;
      shade_unshadowed(batch.points, LightConstants(light.prepared), batch.places, rays);
      std::size_t next = 0, lit = 0;
      for (std::size_t i = 0; i < batch.subjects.size(); ++i) {
        const Expected e = expected(light.prepared, batch.subjects[i], batch.at(i));
        const bool sent = next < rays.count && rays.point[next] == i;
        const glm::vec3 carried = sent ? at(rays.carried, next) : glm::vec3(0.0f);
        EXPECT_LE(largest(carried - e.unshadowed), relative * largest(e.unshadowed))
            << "point " << i;
        lit += sent;
        next += sent;
      }
      EXPECT_EQ(next, rays.count);
      EXPECT_GT(lit, 100u);
    }
  }
}

/// All bits of a result.
std::vector<std::uint32_t> bits_of(const ShadowRayBatch& rays) {
  std::vector<std::uint32_t> bits;
  for (std::size_t i = 0; i < rays.count; ++i) {
    bits.push_back(rays.point[i]);
    bits.push_back(std::bit_cast<std::uint32_t>(rays.t_far[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      bits.push_back(std::bit_cast<std::uint32_t>(rays.origin[k][i]));
      bits.push_back(std::bit_cast<std::uint32_t>(rays.direction[k][i]));
      bits.push_back(std::bit_cast<std::uint32_t>(rays.carried[k][i]));
    }
  }
  return bits;
}

TEST(LightKernel, AllInstructionSetsGiveTheSameBits) {
  std::vector<std::vector<std::uint32_t>> first;
  int targets = 0;
  for_every_target([&] {
    std::vector<std::vector<std::uint32_t>> bits;
    for (const auto& [scale, offset] : scales) {
      const LitSubjects batch(99, scale, offset);
      for (const NamedLight& light : lights(scale, offset)) {
        ShadowRayBatch rays;
        shade_batch(batch.points, LightConstants(light.prepared), batch.places, rays);
        bits.push_back(bits_of(rays));
        if (light.prepared.shape != LightShape::rectangle) continue;
        ShadowRayBatch unshadowed;
        shade_unshadowed(batch.points, LightConstants(light.prepared), batch.places, unshadowed);
        bits.push_back(bits_of(unshadowed));
      }
    }
    ++targets;
    if (first.empty()) first = bits;
    ASSERT_EQ(first.size(), bits.size());
    for (std::size_t i = 0; i < bits.size(); ++i) EXPECT_EQ(first[i], bits[i]) << "light " << i;
  });
  EXPECT_GE(targets, 1);
}

TEST(LightKernel, APointsRayDoesNotDependOnItsPlaceInTheBatch) {
  const LitSubjects batch(5, 1.0, {0, 0, 0});
  for (const NamedLight& light : lights(1.0, {0, 0, 0})) {
    SCOPED_TRACE(light.name);
    ShadowRayBatch all, alone;
    shade_batch(batch.points, LightConstants(light.prepared), batch.places, all);
    for (std::size_t k = 0; k < all.count; k += 13) {
      const std::size_t i = all.point[k];
      ShadingPoints one;
      one.add(batch.subjects[i].lit(), glm::vec3(1.0f));
      LightPointBatch places;
      places.u[0] = batch.places.u[i];
      places.v[0] = batch.places.v[i];
      shade_batch(one, LightConstants(light.prepared), places, alone);
      ASSERT_EQ(alone.count, 1u);
      EXPECT_EQ(at(alone.carried, 0), at(all.carried, k));
      EXPECT_EQ(at(alone.direction, 0), at(all.direction, k));
      EXPECT_EQ(at(alone.origin, 0), at(all.origin, k));
      EXPECT_EQ(alone.t_far[0], all.t_far[k]);
    }
  }
}

TEST(LightKernel, WhatIsNotFiniteIsCountedAndLeftOut) {
  const PreparedLight light = prepare_light(point_light());
  RandomSpace space(1);
  LitSubject s = subject(space, 1, 1.0, {0, 0, 0});
  s.point->position = {0, 0, 0};
  s.point->shading_normal = s.point->geometric_normal = {0, 1, 0};
  s.share = glm::vec3(std::numeric_limits<float>::infinity());
  ShadingPoints points;
  points.add(s.lit(), glm::vec3(1.0f));
  ShadowRayBatch rays;
  shade_batch(points, LightConstants(light), {}, rays);
  EXPECT_EQ(rays.count, 0u);
  EXPECT_EQ(rays.rejected, 1u);
}

TEST(LightKernel, AtTheVeryPlaceOfALightNothingArrives) {
  RandomSpace space(2);
  for (const NamedLight& light : lights(1.0, {0, 0, 0})) {
    SCOPED_TRACE(light.name);
    if (!light.prepared.extended() || light.prepared.shape == LightShape::sun ||
        light.prepared.shape == LightShape::ball)
      continue;
    ShadingPoints points;
    LitSubject s = subject(space, 1, 1.0, {0, 0, 0});
    s.point->position = glm::vec3(light.prepared.position);
    points.add(s.lit(), glm::vec3(1.0f));
    ShadowRayBatch rays;
    shade_batch(points, LightConstants(light.prepared), {}, rays);
    EXPECT_EQ(rays.rejected, 0u);
  }
}

}  // namespace
}  // namespace asos::test::light_kernel_test
