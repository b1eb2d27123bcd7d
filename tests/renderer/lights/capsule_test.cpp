#include "renderer/lights/kinds/capsule.h"

#include "renderer/lights/form_factor.h"
#include "renderer/lights/light_window.h"
#include "tests/support/light_oracle.h"
#include "tests/support/random_space.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asos::capsule_test {
namespace {

using std::numbers::pi;
const glm::dvec3 up(0, 1, 0);

PreparedLight tube(glm::dvec3 middle, glm::dvec3 half, double radius) {
  Light light = test::capsule_light(radius);
  light.position = middle;
  light.half_u = half;
  return prepare_light(light);
}

/// Returns the integral of the cosine over an arc of directions from flat - `most` to flat + `most`
/// radians towards `across`, per radian of longitude.
double across_form(glm::dvec3 flat, glm::dvec3 across, double most, const Receiver& receiver) {
  double low = -most, high = most;
  for (const glm::dvec3& n : {receiver.normal, receiver.geometric}) {
    const double level = glm::dot(n, flat), slope = glm::dot(n, across);
    const double horizon = std::atan2(-level, std::abs(slope));
    // Above the horizon: angles from it on, in the direction in which the ray rises.
    (slope > 0.0 ? low : high) = slope > 0.0 ? std::max(low, horizon) : std::min(high, -horizon);
  }
  if (!(low < high)) return 0.0;
  const auto integral = [&](double b) {  // of cos(b) (level cos(b) + slope sin(b))
    return 0.5 * glm::dot(receiver.normal, flat) * (b + std::sin(b) * std::cos(b)) +
           0.5 * glm::dot(receiver.normal, across) * std::sin(b) * std::sin(b);
  };
  return integral(high) - integral(low);
}

/// From outside the infinite cylinder: bisection finds the latitudes, so this depends on no formula
/// of the silhouette.
double capsule_oracle(const PreparedLight& light, const Receiver& receiver) {
  const glm::dvec3 along = glm::normalize(light.half_u);
  const glm::dvec3 to_middle = light.position - receiver.position;
  const glm::dvec3 foot = to_middle - glm::dot(to_middle, along) * along;
  const double height = glm::length(foot);
  const glm::dvec3 across = glm::cross(foot / height, along);
  std::vector<double> breaks;
  for (const double side : {-1.0, 1.0}) {
    const double s = glm::dot(to_middle + side * light.half_u, along);
    breaks.push_back(std::atan2(s, height) +
                     side * std::asin(light.radius / std::hypot(s, height)));
    breaks.push_back(std::atan2(s * height, height * height - light.radius * light.radius));
  }
  // The part above the horizons may be too small to be found otherwise.
  std::sort(breaks.begin(), breaks.end());
  const double low = breaks.front(), high = breaks.back();
  for (const glm::dvec3& n : {receiver.normal, receiver.geometric}) {
    const double slope = std::atan2(glm::dot(n, foot), -glm::dot(n, along) * height);
    for (const double psi : {slope - pi, slope, slope + pi})
      if (psi > low && psi < high) breaks.push_back(psi);
  }
  for (int i = 1; i < 32; ++i) breaks.push_back(low + i * (high - low) / 32);
  const test::Function at = [&](double psi) {
    const glm::dvec3 flat = std::cos(psi) * (foot / height) + std::sin(psi) * along;
    const double most = test::capsule_latitude(light, receiver.position, flat, across);
    return across_form(flat, across, most, receiver);
  };
  return test::integrate(at, breaks, 1e-7);
}

TEST(CapsuleForm, AgreesWithIntegrationForAllSizes) {
  test::RandomSpace random(31);
  int lit = 0, cut = 0;
  for (int round = 0; round < 60; ++round) {
    for (const double radius : {1e-4, 0.01, 0.2, 1.0, 10.0}) {
      const glm::dvec3 half = random.between(0.1, 3.0) * random.direction();
      const glm::dvec3 middle = random.direction();
      // Every fourth receiver grazes the infinite cylinder, between the ends or beyond.
      const double gap = round % 4 == 0 ? std::pow(10.0, random.between(-5.0, -1.0)) : 1.0;
      const glm::dvec3 position =
          middle + random.between(-3.0, 3.0) * half +
          radius * (1.0 + gap) * random.perpendicular(glm::normalize(half)) +
          (round % 4 == 1 ? 1.0 : 0.0) * random.perpendicular(glm::normalize(half));
      const PreparedLight light = tube(middle, half, radius);
      if (!SeenCapsule::of(middle - position, half, radius)) continue;
      const Receiver receiver =
          random.receiver(position, middle + random.between(-1.0, 1.0) * half, round);
      const double expected = capsule_oracle(light, receiver);
      EXPECT_NEAR(capsule_form(middle - half, middle + half, radius, receiver), expected,
                  3e-5 * expected + 1e-9 * radius)
          << "radius " << radius << ", round " << round;
      lit += expected > 0.0;
      cut += round % 3 != 0 && expected > 0.0;
    }
  }
  EXPECT_GT(lit, 150);
  EXPECT_GT(cut, 80);
}

TEST(CapsuleForm, EqualsBallWithinTheExtensionOfItsCylinder) {
  const glm::dvec3 half(0, 0.8, 0), middle(0, 2, 0);
  for (const double aside : {0.0, 0.1, 0.2, 0.29}) {
    const Receiver receiver{{aside, 0.1, 0}, glm::normalize(glm::dvec3(0.5, 0.5, 0.1)), up};
    EXPECT_DOUBLE_EQ(capsule_form(middle - half, middle + half, 0.3, receiver),
                     ball_form(middle - half, 0.3, receiver));
  }
  const Receiver inside{{0.1, 2.2, 0}, up, up};
  EXPECT_DOUBLE_EQ(capsule_form(middle - half, middle + half, 0.3, inside), pi);
}

TEST(CapsuleForm, IsContinuousWhereItsCylinderBegins) {
  const glm::dvec3 half(0, 0.8, 0), middle(0, 2, 0);
  const auto form = [&](double aside) {
    return capsule_form(middle - half, middle + half, 0.3,
                        {{aside, 0.1, 0}, glm::normalize(glm::dvec3(-0.9, 0.5, 0.1)), up});
  };
  EXPECT_NEAR(form(0.3 - 1e-9), form(0.3 + 1e-9), 1e-6 * form(0.3));
  EXPECT_NEAR(form(0.3), form(0.3 + 1e-12), 1e-6 * form(0.3));
}

TEST(Capsule, ApproachesLineAndBall) {
  test::RandomSpace random(32);
  for (int round = 0; round < 24; ++round) {
    const Receiver receiver = random.receiver(2.0 * random.direction(), {0, 0, 0}, round % 3);
    const glm::dvec3 half = random.between(0.2, 1.0) * random.direction();
    const auto irradiance = [&](glm::dvec3 half_u, double radius) {
      return static_cast<double>(
          unshadowed_irradiance(tube(glm::dvec3(0.0), half_u, radius), receiver).r);
    };
    const double line = irradiance(half, 0.0), thin = irradiance(half, 1e-6);
    EXPECT_NEAR(thin, line, 1e-5 * line + 1e-6) << round;
    const double ball = irradiance(glm::dvec3(0.0), 0.4);
    EXPECT_NEAR(irradiance(1e-7 * half, 0.4), ball, 2e-6 * ball + 1e-9) << round;
  }
}

TEST(Capsule, SamplesAreUniformBySolidAngle) {
  test::RandomSpace random(33);
  int seen_count = 0;
  for (int round = 0; round < 40; ++round) {
    const double radius = std::pow(10.0, random.between(-4.0, 0.0));
    const PreparedLight light = tube(random.between(0.5, 3.0) * random.direction(),
                                     random.between(0.1, 2.0) * random.direction(), radius);
    const auto seen = SeenCapsule::of(light.position, light.half_u, radius);
    if (!seen) continue;
    ++seen_count;
    const CapsuleDirections directions(*seen);
    // The area up to the longitude of u, by integration, is the part u of the whole.
    const auto longitude = [&](glm::dvec3 p) {
      return std::atan2(glm::dot(p, seen->along), glm::dot(p, seen->foot));
    };
    const double tip = longitude(directions.direction(0.0, 0.5));
    const auto side = [&](const SeenCapsule::End& end) {
      return longitude(seen->on_arc(end, end.arc));
    };
    for (const double u : {0.01, 0.1, 0.3, 0.5, 0.8, 0.97, 1.0}) {
      const double at = longitude(directions.direction(u, 0.5));
      const test::Function width = [&](double psi) {
        const glm::dvec3 flat = std::cos(psi) * seen->foot + std::sin(psi) * seen->along;
        return 2.0 * std::sin(test::capsule_latitude(light, {0, 0, 0}, flat, seen->across));
      };
      std::vector<double> breaks{tip, at};
      for (const SeenCapsule::End& end : seen->ends)
        if (side(end) > tip && side(end) < at) breaks.push_back(side(end));
      const double area = test::integrate(width, breaks, 1e-7);
      EXPECT_NEAR(area / directions.solid_angle(), u, 1e-5) << "radius " << radius << ", u " << u;
    }
  }
  EXPECT_GT(seen_count, 20);
}

TEST(Capsule, WindowHoldsWholeSilhouette) {
  test::RandomSpace random(34);
  for (int round = 0; round < 60; ++round) {
    const PreparedLight light = tube(glm::dvec3(0.0), random.between(0.1, 2.0) * random.direction(),
                                     random.between(0.01, 0.5));
    const glm::dvec3 apex = random.between(0.8, 3.0) * random.direction();
    const auto window = light_window(light, apex);
    if (!window) continue;
    const glm::dvec3 facing = glm::cross(window->half_u, window->half_v);
    const double level = glm::dot(facing, window->middle);
    for (int i = 0; i < 60; ++i) {
      const LightSample sample =
          sample_light(light, {apex, up, up}, random.between(0.0, 1.0), random.between(0.0, 1.0));
      const double t = level / glm::dot(facing, sample.direction);
      ASSERT_GT(t, 0.0);
      const glm::dvec3 p = t * sample.direction - window->middle;
      for (const glm::dvec3& side : {window->half_u, window->half_v})
        EXPECT_LE(std::abs(glm::dot(p, side)) / glm::dot(side, side), 1.05) << round;
      EXPECT_LE(sample.distance, t * (1.0 + 1e-9));
      EXPECT_NEAR(way_to_light(light, apex, 2.0 * sample.direction), 0.5 * sample.distance, 1e-9);
    }
  }
}

TEST(Capsule, IsMetWhereItsSamplesAre) {
  test::RandomSpace random(35);
  const PreparedLight light = prepare_light(test::capsule_light());
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 from = light.position + 2.0 * random.direction();
    const LightSample sample =
        sample_light(light, {from, up, up}, random.between(0.0, 1.0), random.between(0.05, 0.95));
    Ray ray;
    ray.origin = glm::vec3(from);
    ray.direction = glm::vec3(sample.direction);
    const auto hit = meet_light(light, ray);
    ASSERT_TRUE(hit) << i;
    EXPECT_NEAR(hit->t, sample.distance, 2e-3);
    ray.direction = -ray.direction;
    EXPECT_FALSE(meet_light(light, ray)) << i;
  }
}

// From outside, within the extension of the cylinder, and inside. The first sees the whole capsule,
// the second one ball, and the third all directions.
TEST(Capsule, HitsHaveTheDensityOfSamples) {
  test::RandomSpace random(36);
  const PreparedLight light = prepare_light(test::capsule_light());
  const auto unit = [&] { return random.between(0.1, 0.9); };
  std::array<int, 3> found{};
  for (int i = 0; i < 300; ++i) {
    const std::size_t place = i % 3;
    const double end = i % 2 == 0 ? 1.0 : -1.0;
    const glm::dvec3 along = (end / glm::length(light.half_u)) * light.half_u;
    const glm::dvec3 aside = 0.9 * unit() * light.radius * random.direction();
    const std::array offsets{2.0 * random.direction(),
                             end * light.half_u + (light.radius + unit()) * along + aside,
                             unit() * end * light.half_u + aside};
    const glm::dvec3 from = light.position + offsets[place];
    const glm::dvec3 normal = place == 1 ? -along : random.direction();
    const Receiver receiver{from, normal, normal};
    const LightSample sample = sample_light(light, receiver, unit(), unit());
    const double cosine = glm::dot(normal, sample.direction);
    if (!(cosine > 0.05)) continue;
    ++found[place];
    const auto hit =
        LightGeometry<LightShape::capsule>::sampled_hit(light, receiver, sample.direction);
    ASSERT_TRUE(hit) << i;
    EXPECT_NEAR(hit->distance, sample.distance, 1e-6) << i;
    EXPECT_NEAR(sample.irradiance.x * hit->density / (light.power.x * cosine), 1.0, 1e-5) << i;
  }
  for (const int count : found) EXPECT_GT(count, 30);
}

}  // namespace
}  // namespace asos::capsule_test
