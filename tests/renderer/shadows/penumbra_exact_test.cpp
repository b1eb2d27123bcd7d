#include "tests/support/make_light.h"
#include "tests/support/random_space.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Penumbrae of flat and linear lights behind straight-edged occluders, against closed forms: the
// light's polygon clipped by planes through the receiver and the occluder's edges.

namespace asos::test::penumbra_exact_test {
namespace {

Light rectangle_in(RandomSpace& random, glm::dvec3 middle) {
  Light light{.type = Light::Type::rectangle, .position = middle};
  const glm::dvec3 u = random.direction();
  light.half_u = random.between(0.1, 1.0) * u;
  light.half_v = random.between(0.1, 1.0) * random.perpendicular(u);
  light.direction = glm::normalize(glm::cross(light.half_u, light.half_v));
  light.two_sided = true;
  return light;
}

Light tube_in(RandomSpace& random, glm::dvec3 middle) {
  return {.type = Light::Type::linear,
          .position = middle,
          .half_u = random.between(0.1, 1.5) * random.direction()};
}

/// A receiver that a fixture places without rounding.
Receiver receiver_near_origin(RandomSpace& random, glm::dvec3 target, int kind) {
  const glm::dvec3 position(glm::vec3(0.5 * random.between(0.0, 1.0) * random.direction()));
  Receiver receiver = random.receiver(position, target, kind);
  receiver.normal = glm::dvec3(glm::vec3(receiver.normal));
  receiver.geometric = glm::dvec3(glm::vec3(receiver.geometric));
  return receiver;
}

/// A quad so large that only its edge through `through` is visible from nearby. Its plane may
/// intersect the light.
Polygon3 add_half_plane(World& world, RandomSpace& random, glm::dvec3 through) {
  const glm::dvec3 edge = random.direction();
  const glm::dvec3 inwards = random.perpendicular(edge);
  return add_occluder(world, through - 50.0 * edge, 100.0 * edge, 50.0 * inwards);
}

class Worst {
 public:
  explicit Worst(double allowed) : allowed_(allowed) {}
  ~Worst() { testing::Test::RecordProperty("worst_error", testing::PrintToString(worst_)); }

  void expect(double found, double exact, int where) {
    EXPECT_NEAR(found, exact, allowed_) << where;
    worst_ = std::max(worst_, std::abs(found - exact));
    partly_ += exact > 0.01 && exact < 0.99;
  }
  /// Number of cases in the penumbra.
  [[nodiscard]] int partly() const { return partly_; }

 private:
  double allowed_;
  double worst_ = 0.0;
  int partly_ = 0;
};

// Visible fractions of rectangles behind some half-planes.
void expect_half_planes(int planes, int worlds, std::uint64_t seed) {
  RandomSpace random(seed);
  Worst worst(1e-4);
  for (int w = 0; w < worlds; ++w) {
    const glm::dvec3 middle = 3.0 * random.direction();
    const Light light = rectangle_in(random, middle);
    World world;
    std::vector<Polygon3> occluders;
    for (int i = 0; i < planes; ++i) {
      const glm::dvec3 through =
          random.between(0.2, 0.8) * middle + 0.3 * random.between(0, 1) * random.direction();
      occluders.push_back(add_half_plane(world, random, through));
    }
    ShadowFixture fixture(std::move(world), light);
    for (int i = 0; i < 50; ++i) {
      const Receiver receiver = receiver_near_origin(random, middle, i);
      const double all = form_of(corners_of(light), receiver);
      if (all < 1e-4) continue;  // practically below the horizon
      worst.expect(fixture.visibility(receiver),
                   seen_form(corners_of(light), occluders, receiver) / all, 1000 * w + i);
    }
  }
  EXPECT_GT(worst.partly(), worlds * 5);
}

TEST(Penumbra, OfAHalfPlaneIsExact) {
  expect_half_planes(1, 40, 1);
}

TEST(Penumbra, OfCrossingHalfPlanesIsExact) {
  expect_half_planes(2, 40, 2);
  expect_half_planes(3, 20, 3);
}

// A plate with a five-sided hole.
TEST(Penumbra, ThroughAnApertureIsExact) {
  RandomSpace random(4);
  Worst worst(1e-4);
  for (int w = 0; w < 20; ++w) {
    const glm::dvec3 middle = 3.0 * random.direction();
    const Light light = rectangle_in(random, middle);
    const glm::dvec3 x = random.perpendicular(middle), z = glm::normalize(middle);
    const glm::dvec3 y = glm::cross(z, x);
    const double radius = random.between(0.05, 0.5);
    std::vector<TinyVertex> vertices;
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 0; i < 5; ++i) {
      const double angle = 0.4 * std::numbers::pi * i + random.between(0.0, 0.5);
      const glm::dvec3 across = std::cos(angle) * x + std::sin(angle) * y;
      for (const double r : {radius, 60.0})
        vertices.push_back({glm::vec3(0.5 * middle + r * across), glm::vec3(z), {}});
      const std::uint32_t next = (i + 1) % 5;
      triangles.emplace_back(2 * i, 2 * i + 1, 2 * next + 1);
      triangles.emplace_back(2 * i, 2 * next + 1, 2 * next);
    }
    World world;
    add_part(world, vertices, triangles, matte({0.5f, 0.5f, 0.5f}));
    Polygon3 hole;
    for (int i = 0; i < 5; ++i) hole.emplace_back(world.positions[static_cast<std::size_t>(2 * i)]);
    ShadowFixture fixture(std::move(world), light);
    for (int i = 0; i < 50; ++i) {
      const Receiver receiver = receiver_near_origin(random, middle, i);
      const double all = form_of(corners_of(light), receiver);
      const Polygon3 before = clip(corners_of(light), -z, 0.5 * middle);
      if (all < 1e-4 || before.size() > 2) continue;
      const Polygon3 seen = hidden_part(corners_of(light), hole, receiver.position);
      worst.expect(fixture.visibility(receiver), form_of(seen, receiver) / all, 1000 * w + i);
    }
  }
  EXPECT_GT(worst.partly(), 200);
}

// A bar a hundredth as wide as the light, moving between light and receiver.
TEST(Penumbra, OfAThinBarNeitherVanishesNorPulsates) {
  for (int max_level = 1; max_level <= 4; ++max_level) {
    ShadowRules settings{.error_budget = {.max_level = max_level}};
    const Light light = make_panel({0, 0, 2}, {0, 0, -1}, {0.5, 0, 0}, {0, 0.5, 0});
    Worst worst(1e-4);
    for (int step = 0; step < 200; ++step) {
      World world;
      const glm::dvec3 along = glm::normalize(glm::dvec3(0.2, 1.0, 0.1));
      const Polygon3 bar = add_occluder(world, glm::dvec3(-0.45 + 0.0045 * step, 0, 1) - along,
                                        {0.005, 0, 0}, 2.0 * along);
      ShadowFixture fixture(std::move(world), light, settings);
      Receiver receiver{.position = {glm::vec3(0.1f, -0.05f, 0.02f)}};
      receiver.normal = receiver.geometric = {0, 0, 1};
      const double all = form_of(corners_of(light), receiver);
      worst.expect(fixture.visibility(receiver),
                   seen_form(corners_of(light), {bar}, receiver) / all, step);
    }
  }
}

/// The range of parameters, within -1 to 1, that a convex occluder hides of a line seen from `eye`
/// (empty if reversed).
std::pair<double, double> hidden_interval(const Light& tube, const Polygon3& occluder,
                                          glm::dvec3 eye) {
  const glm::dvec3 face = glm::cross(occluder[1] - occluder[0], occluder[2] - occluder[0]);
  const double side = glm::dot(face, eye - occluder[0]) > 0.0 ? 1.0 : -1.0;
  double t0 = -1.0, t1 = 1.0;
  const auto keep = [&](glm::dvec3 normal, glm::dvec3 origin) {
    const double at = glm::dot(normal, tube.position - origin);
    const double slope = glm::dot(normal, tube.half_u);
    if (slope > 0.0) t0 = std::max(t0, -at / slope);
    if (slope < 0.0) t1 = std::min(t1, -at / slope);
  };
  keep(-side * face, occluder[0]);
  for (std::size_t i = 0; i < occluder.size(); ++i)
    keep(-side * glm::cross(occluder[i] - eye, occluder[(i + 1) % occluder.size()] - eye), eye);
  return {t0, t1};
}

/// `horizons`: receivers of all kinds; otherwise only those whose horizons do not cut the light.
void expect_linear(std::uint64_t seed, bool horizons) {
  RandomSpace random(seed);
  Worst worst(1e-5);
  for (int w = 0; w < 40; ++w) {
    const glm::dvec3 middle = 3.0 * random.direction();
    const Light light = tube_in(random, middle);
    World world;
    std::vector<Polygon3> occluders;
    while (occluders.size() < 4) {
      const glm::dvec3 along = random.direction();
      const glm::dvec3 a = random.between(0.05, 0.5) * along;
      const glm::dvec3 through = random.between(0.3, 0.8) * middle + 0.4 * random.direction();
      const glm::dvec3 b = random.between(0.05, 0.5) * random.perpendicular(along);
      // A surface that intersects the light ends its shadow without an edge.
      const glm::dvec3 plane = glm::cross(a, b);
      const auto side = [&](double t) {
        return glm::dot(plane, middle + t * light.half_u - through) > 0.0;
      };
      if (side(-1.0) != side(1.0)) continue;
      occluders.push_back(add_occluder(world, through, a, b));
    }
    ShadowFixture fixture(std::move(world), light);
    for (int i = 0; i < 50; ++i) {
      const Receiver receiver = receiver_near_origin(random, middle, i);
      const auto form = [&](double t0, double t1) {
        return static_cast<double>(segment_irradiance(fixture.light(), receiver, t0, t1).x);
      };
      const double all = form(-1.0, 1.0);
      if (all < 1e-4) continue;
      bool below = false;
      for (const glm::dvec3& up : {receiver.normal, receiver.geometric})
        for (const double t : {-1.0, 1.0})
          below |= glm::dot(up, middle + t * light.half_u - receiver.position) <= 0.0;
      if (below && !horizons) continue;
      std::vector<std::pair<double, double>> hidden;
      for (const Polygon3& occluder : occluders)
        if (const auto part = hidden_interval(light, occluder, receiver.position);
            part.first < part.second)
          hidden.push_back(part);
      std::sort(hidden.begin(), hidden.end());
      double seen = 0.0, end = -1.0;
      hidden.emplace_back(1.0, 1.0);
      for (const auto& [t0, t1] : hidden) {
        if (t0 > end) seen += form(end, t0);
        end = std::max(end, t1);
      }
      worst.expect(fixture.visibility(receiver), seen / all, 1000 * w + i);
    }
  }
  EXPECT_GT(worst.partly(), 200);
}

TEST(Penumbra, OfALinearLightBehindSeveralOccludersIsExact) {
  expect_linear(5, false);
}

TEST(Penumbra, OfALinearLightAcrossTheHorizonIsExact) {
  expect_linear(6, true);
}

}  // namespace
}  // namespace asos::test::penumbra_exact_test
