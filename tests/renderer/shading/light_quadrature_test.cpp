#include "renderer/shading/light_quadrature.h"

#include "tests/support/make_light.h"
#include "tests/support/random_space.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/sample_lights.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

// Light reflected by surfaces, against a finer, independent quadrature in double precision.

namespace asos::test::light_quadrature_test {
namespace {

constexpr double roughnesses[] = {0.1, 0.2, 0.3, 0.45, 0.6, 1.0};
constexpr double degrees[] = {0.0, 30.0, 60.0, 75.0};

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A light of this kind in a direction from the origin.
PreparedLight light_at(const std::string& kind, glm::dvec3 towards, double distance, double size) {
  Light light = make_bulb(distance * towards, 1.0f);
  light.color = glm::vec3(1.0f);
  light.direction = -glm::normalize(towards + glm::dvec3(0.3, 0.2, 0.1));
  const glm::dvec3 u = glm::normalize(glm::cross(light.direction, glm::dvec3(0.1, 0.9, 0.3)));
  const glm::dvec3 v = glm::cross(light.direction, u);
  light.half_u = size * u;
  light.half_v = 0.5 * size * v;
  light.radius = kind == "ball" ? 0.5 * size : size;
  light.angular_diameter_rad = 2.0 * std::atan(size / distance);
  if (kind == "rectangle") light.type = Light::Type::rectangle;
  if (kind == "disk") light.type = Light::Type::disk;
  if (kind == "sun") light.type = Light::Type::directional;
  if (kind == "line" || kind == "capsule") light.type = Light::Type::linear;
  if (kind == "line") light.radius = 0.0;
  if (kind == "capsule") light.radius = 0.3 * size;
  if (kind == "polygon") {
    light.type = Light::Type::polygon;
    const auto outline = [&](double x, double y) {
      const glm::dvec3 p = light.position;
      return std::vector<glm::dvec3>{p - x * u - y * v, p + x * u - y * v, p + x * u + y * v,
                                     p - x * u + y * v};
    };
    light.outlines = {outline(size, 0.6 * size), outline(0.5 * size, 0.2 * size)};
  }
  PreparedLight prepared = prepare_light(light);
  prepared.power = glm::vec3(1.0f);
  return prepared;
}

const char* const kinds[] = {"rectangle", "disk", "ball", "line", "capsule", "polygon", "sun"};

struct Errors {
  double worst = 0.0, sum = 0.0, values = 0.0;
  int count = 0;
  void add(double value, double expected) {
    worst = std::max(worst, std::abs(value - expected));
    sum += std::abs(value - expected);
    values += expected;
    ++count;
  }
  [[nodiscard]] double mean_share() const { return sum / values; }
  [[nodiscard]] double worst_share() const { return worst * count / values; }
};

/// Adds the errors of a lobe with f0 = 1 and of a grey dielectric, for one roughness and angle.
void add_errors(const std::string& kind, double roughness, double theta, Errors& metal,
                Errors& dielectric, int& cells) {
  const glm::dvec3 up(0, 0, 1);
  const Receiver receiver{glm::dvec3(0.0), up, up};
  const glm::dvec3 v = direction(theta, std::numbers::pi);
  LightQuadrature quadrature(receiver, v, white_lobe(roughness));
  LightQuadrature dull(receiver, v, white_lobe(roughness, 0.04f));
  const double lobe = std::min(1.0, 2.0 * roughness * roughness);
  const SeenPoint at{glm::dvec3(0.0), up, v};
  for (const auto& [towards, distance, size] :
       {std::tuple{direction(theta, 0.0), 2.0, 0.6},
        {direction(theta, 0.0), 30.0, 0.6},
        {direction(std::max(0.0, theta - lobe), 0.4 * lobe), 2.0, 0.3},
        {direction(theta, 1.5 * lobe), 1.0, 1.0},
        {direction(0.5, 2.0), 1.2, 0.8},
        {direction(1.5, 0.2), 1.5, 0.7}}) {
    const PreparedLight light = light_at(kind, towards, distance, size);
    const ReflectedIntegral found = quadrature(light);
    cells = std::max(cells, quadrature.cells());
    metal.add(found.lobe, reflected_radiance(light, {glm::dvec3(1.0), 1.0, roughness}, at).x);
    const double irradiance = static_cast<double>(unshadowed_irradiance(light, receiver).x);
    const ReflectedIntegral less = dull(light);
    const double value = 0.96 * std::numbers::inv_pi * (irradiance - less.scattered) +
                         0.04 * less.lobe + 0.96 * less.fresnel;
    dielectric.add(value, reflected_radiance(light, {glm::dvec3(1.0), 0.0, roughness}, at).x);
  }
}

// Mean and worst errors for one light in all places, relative to the mean value.
TEST(LightQuadrature, AgreesWithAFinerOne) {
  for (const char* kind : kinds) {
    for (const double roughness : roughnesses) {
      Errors metal, dielectric;
      int cells = 0;
      for (const double angle : degrees)
        add_errors(kind, roughness, angle * std::numbers::pi / 180.0, metal, dielectric, cells);
      const std::string at = std::string(kind) + ' ' + std::to_string(roughness);
      EXPECT_LT(metal.mean_share(), 2e-4) << at;
      EXPECT_LT(metal.worst_share(), 1e-3) << at;
      EXPECT_LT(dielectric.mean_share(), 2e-3) << at;
      EXPECT_LT(dielectric.worst_share(), 2e-2) << at;
      EXPECT_LT(cells, 2048) << at << ": ends early";
    }
  }
}

// A round light that is small relative to the lobe needs one cell for the same accuracy.
TEST(LightQuadrature, ASmallRoundLightIsOneCell) {
  const glm::dvec3 up(0, 0, 1);
  const Receiver receiver{glm::dvec3(0.0), up, up};
  for (const char* kind : {"disk", "ball", "sun"}) {
    for (const double roughness : {0.3, 0.45, 0.6, 1.0}) {
      for (const double aside : {0.0, 0.2, 0.7}) {
        const glm::dvec3 v = direction(0.6, std::numbers::pi);
        const PreparedLight light = light_at(kind, direction(0.6 + aside, 0.0), 30.0, 0.3);
        LightQuadrature quadrature(receiver, v, white_lobe(roughness));
        const double found = quadrature(light).lobe;
        EXPECT_EQ(quadrature.cells(), 1) << kind << ' ' << roughness << ' ' << aside;
        const double truth =
            reflected_radiance(light, {glm::dvec3(1.0), 1.0, roughness}, {glm::dvec3(0.0), up, v})
                .x;
        EXPECT_NEAR(found, truth, 2e-4 * truth) << kind << ' ' << roughness << ' ' << aside;
      }
    }
  }
}

// Closed forms: the solid angle of a cone, and the projected one of a disk at normal incidence.
TEST(LightQuadrature, QuartersOfACellSumToTheLight) {
  std::vector<LightPatch> patches;
  const Receiver receiver{glm::dvec3(0.0), {0, 0, 1}, {0, 0, 1}};
  const PreparedLight sun = light_at("sun", direction(0.0, 0.0), 10.0, 1.0);
  find_light_patches(sun, receiver, patches);
  ASSERT_EQ(patches.size(), 4u);
  double cone = 0.0;
  for (const float solid_angle :
       LightPatch::cell_of_quarters(std::span<const LightPatch, 4>(patches)).solid_angle)
    cone += static_cast<double>(solid_angle);
  const double whole = 2.0 * std::numbers::pi * (1.0 - std::cos(std::atan(0.1)));
  EXPECT_NEAR(cone, whole, 1e-5 * whole);

  Light round;
  round.type = Light::Type::disk;
  round.color = glm::vec3(1.0f);
  round.position = {0, 0, 10};
  round.direction = {0, 0, -1};
  round.half_u = {1, 0, 0};
  round.half_v = {0, -1, 0};
  round.radius = 1.0;
  find_light_patches(prepare_light(round), receiver, patches);
  ASSERT_EQ(patches.size(), 4u);
  const LightPatch::Cell cell =
      LightPatch::cell_of_quarters(std::span<const LightPatch, 4>(patches));
  double form = 0.0;
  for (std::size_t i = 0; i < LightPatch::cell_nodes; ++i)
    form += static_cast<double>(cell.z[i] * cell.solid_angle[i]);
  EXPECT_NEAR(form, std::numbers::pi / 101.0, 1e-5 * std::numbers::pi / 101.0);
}

// At grazing angles narrow lobes are distorted, and cut by the horizon.
TEST(LightQuadrature, AgreesLessWellAtGrazingAngles) {
  for (const char* kind : kinds) {
    for (const double roughness : roughnesses) {
      Errors metal, dielectric;
      int cells = 0;
      add_errors(kind, roughness, 85.0 * std::numbers::pi / 180.0, metal, dielectric, cells);
      EXPECT_LT(metal.mean_share(), 0.05) << kind << ' ' << roughness;
      EXPECT_LT(dielectric.mean_share(), 0.05) << kind << ' ' << roughness;
    }
  }
}

// A line light is integrated from the point where it crosses the horizon of the shading or the
// geometric normal.
TEST(LightQuadrature, ALineThatSetsEndsAtTheHorizon) {
  const glm::dvec3 up(0, 0, 1);
  for (const double tilt : {0.3, 1.0, -0.7}) {
    Light light;
    light.type = Light::Type::linear;
    light.color = glm::vec3(1.0f);
    light.intensity = 1.0f;
    light.position = {0.8, 0.3, 0.12};
    light.half_u = 0.6 * glm::dvec3(std::cos(tilt) * 0.8, std::cos(tilt) * 0.6, std::sin(tilt));
    ASSERT_LT(light.position.z - std::abs(light.half_u.z), 0.0);
    const PreparedLight line = prepare_light(light);
    for (const double roughness : {0.3, 0.6, 1.0}) {
      const glm::dvec3 v = direction(1.0, 2.5);
      const double expected =
          reflected_radiance(line, {glm::dvec3(1.0), 1.0, roughness}, {glm::dvec3(0.0), up, v}, 8.0)
              .x;
      const double power = static_cast<double>(line.power.x);
      const glm::dvec3 beside = glm::normalize(up + glm::dvec3(-0.1, 0.05, 0.0));
      const ReflectedIntegral found =
          LightQuadrature({glm::dvec3(0.0), up, up}, v, white_lobe(roughness))(line);
      EXPECT_NEAR(power * found.lobe, expected, 3e-4 * expected) << tilt << ' ' << roughness;
      const ReflectedIntegral cut =
          LightQuadrature({glm::dvec3(0.0), up, beside}, v, white_lobe(roughness))(line);
      EXPECT_LT(cut.lobe, found.lobe) << tilt << ' ' << roughness;
      EXPECT_GT(cut.lobe, 0.5 * found.lobe) << tilt << ' ' << roughness;
    }
  }
}

TEST(LightQuadrature, WithinABallLightComesFromEverywhere) {
  RandomSpace random(5);
  for (const double roughness : {0.2, 0.5, 1.0}) {
    const glm::dvec3 n = random.direction();
    glm::dvec3 v = random.direction();
    if (glm::dot(n, v) < 0.0) v = -v;
    const PreparedLight ball = light_at("ball", n, 0.1, 2.0);
    const ReflectedIntegral found =
        LightQuadrature({glm::dvec3(0.0), n, n}, v, white_lobe(roughness))(ball);
    const PatchQuadrature sum({glm::dvec3(1.0), 1.0, roughness}, {glm::dvec3(0.0), n, v});
    const glm::dvec3 x = across(n), y = glm::cross(n, x);
    // The hemisphere as five sides of a cube.
    double expected = sum(flat_patch(n - x + y, 2.0 * x, -2.0 * y)).x;
    for (const auto& [side, along] : {std::pair{x, -y}, {-x, y}, {y, x}, {-y, -x}})
      expected += sum(flat_patch(side - along, 2.0 * along, n)).x;
    // At grazing views a narrow lobe is flatter than the cells: 0.7 % was measured.
    const bool grazing = glm::dot(n, v) < 0.2 && roughness < 0.3;
    EXPECT_NEAR(found.lobe, expected, (grazing ? 1e-2 : 1e-3) * expected) << roughness;
  }
}

TEST(LightQuadrature, DoesNotDependOnUnits) {
  const glm::dvec3 up(0, 0, 1);
  for (const char* kind : kinds) {
    const glm::dvec3 towards = direction(0.7, 0.1), v = direction(0.6, std::numbers::pi);
    LightQuadrature quadrature({glm::dvec3(0.0), up, up}, v, white_lobe(0.3));
    const ReflectedIntegral one = quadrature(light_at(kind, towards, 2.0, 0.6));
    EXPECT_GT(one.lobe, 0.0);
    for (const double unit : {1e-6, 1e6}) {
      const ReflectedIntegral other = quadrature(light_at(kind, towards, unit * 2.0, unit * 0.6));
      // The contribution of a metre of a line scales with the distance.
      const double scale = std::string(kind) == "line" ? unit : 1.0;
      EXPECT_NEAR(other.lobe * scale, one.lobe, 1e-5 * one.lobe) << kind;
      EXPECT_NEAR(other.scattered * scale, one.scattered, 1e-5 * one.scattered) << kind;
    }
  }
}

TEST(LightQuadrature, IsFiniteWhereverTheReceiverIs) {
  RandomSpace random(4);
  for (const char* kind : kinds) {
    const PreparedLight light = light_at(kind, {0, 0, 1}, 1.0, 0.5);
    for (const glm::dvec3& position :
         {light.position, light.position + light.half_u, light.position + 2.0 * light.half_u,
          light.position + 1e-9 * light.towards,
          light.position + light.half_u + 1e-12 * light.towards, glm::dvec3(1e12, 0, 0)}) {
      for (int round = 0; round < 20; ++round) {
        LightQuadrature quadrature({position, random.direction(), random.direction()},
                                   random.direction(), white_lobe(random.between(0.0, 1.2)));
        const ReflectedIntegral all = quadrature(light);
        EXPECT_TRUE(std::isfinite(all.lobe + all.fresnel + all.scattered)) << kind;
        EXPECT_GE(all.lobe, 0.0);
        EXPECT_LE(quadrature.cells(), 2100);
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::light_quadrature_test
