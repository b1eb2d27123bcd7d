#include "renderer/shading/specular_integral.h"

#include "renderer/shading/brdf.h"
#include "tests/support/light_oracle.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

// What a surface mirrors of lights in closed form against quadrature of the BRDF itself.

namespace asos::specular_integral_test {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 up(0.0, 0.0, 1.0);
const double kRoughnesses[] = {0.1, 0.2, 0.3, 0.45, 0.6, 1.0};
const double kAngles[] = {0.0, 20.0, 40.0, 60.0, 70.0, 80.0};

/// What interpolating the table may add to its error.
constexpr double interpolated = 0.01;

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

glm::dvec3 mirrored(glm::dvec3 normal, glm::dvec3 to_viewer) {
  return glm::reflect(-to_viewer, normal);
}

/// glTF's specular BRDF with f90 = 1 (appendix B), in double precision.
double brdf_of(glm::dvec3 n, glm::dvec3 v, glm::dvec3 l, double roughness, double f0) {
  const glm::dvec3 h = glm::normalize(v + l);
  const double a2 = std::pow(roughness, 4.0);
  const double nl = glm::dot(n, l);
  const double nv = glm::dot(n, v);
  const glm::dvec3 across = glm::cross(n, h);
  const double nh = glm::dot(n, h);
  const double b = glm::dot(across, across) + a2 * nh * nh;
  const double distribution = a2 / (pi * b * b);
  const auto root = [a2](double x) { return std::sqrt(a2 + (1.0 - a2) * x * x); };
  const double visibility = 0.5 / (nl * root(nv) + nv * root(nl));
  return distribution * visibility * (f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(v, h), 5.0));
}

test::Response response_of(const Receiver& receiver, glm::dvec3 v, double roughness, double f0) {
  return {[=](glm::dvec3 l) { return brdf_of(receiver.normal, v, l, roughness, f0); },
          mirrored(receiver.normal, v), 0.5 * roughness * roughness};
}

/// What a light of shape polygon, disk, ball, sun or segment gives, of radiance (or intensity) 1.
double oracle(const PreparedLight& light, const Receiver& receiver, glm::dvec3 v, double roughness,
              double f0) {
  const test::Response response = response_of(receiver, v, roughness, f0);
  constexpr double tolerance = 1e-5;
  const auto disk = [&](glm::dvec3 centre, glm::dvec3 facing, double radius) {
    const glm::dvec3 other = std::abs(facing.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(facing, other));
    return test::flat_oracle(test::disk_region(centre, u, glm::cross(facing, u), radius), receiver,
                             tolerance, &response);
  };
  // The directions of a cone are those to a disk within it.
  const auto cone = [&](glm::dvec3 axis, double sine) {
    return disk(receiver.position + std::sqrt(1.0 - sine * sine) * axis, -axis, sine);
  };
  switch (light.shape) {
    case PreparedLight::Shape::polygon: {
      const glm::dvec3 x_axis = glm::normalize(light.half_u);
      const glm::dvec3 y_axis = glm::normalize(light.half_v);
      std::vector<std::vector<glm::dvec2>> outlines;
      for (const auto& outline : light.outlines) {
        auto& flat = outlines.emplace_back();
        for (const glm::dvec3& p : outline)
          flat.emplace_back(glm::dot(p - light.position, x_axis),
                            glm::dot(p - light.position, y_axis));
      }
      return test::flat_oracle(test::polygon_region(light.position, x_axis, y_axis, outlines),
                               receiver, tolerance, &response);
    }
    case PreparedLight::Shape::disk:
      return disk(light.position, light.towards, light.radius);
    case PreparedLight::Shape::ball: {
      const glm::dvec3 to_middle = light.position - receiver.position;
      return cone(glm::normalize(to_middle), light.radius / glm::length(to_middle));
    }
    case PreparedLight::Shape::sun:
      return cone(light.towards, std::sin(std::atan(light.radius)));
    case PreparedLight::Shape::segment:
      return test::line_oracle(light.position - light.half_u, light.position + light.half_u,
                               light.rule == LightRule::physical, receiver, &response);
    default:
      return 0.0;
  }
}

double closed_form(const PreparedLight& light, const SpecularView& view, double f0) {
  const SpecularIntegral all = specular_of(light, view);
  return f0 * all.lobe + (1.0 - f0) * all.fresnel;
}

/// Where lights stand about the direction in which the view is mirrored.
struct Place {
  glm::dvec3 towards;
  double distance;
  double size;
};

/// Around the mirrored direction and beside it, near and far, and across the horizon.
std::vector<Place> places(double theta, double roughness) {
  const double lobe = std::min(1.0, 2.0 * roughness * roughness);
  return {{direction(theta, 0.0), 2.0, 0.6},
          {direction(theta, 0.0), 30.0, 0.6},
          {direction(std::max(0.0, theta - lobe), 0.4 * lobe), 2.0, 0.3},
          {direction(theta, 1.5 * lobe), 1.0, 1.0},
          {direction(1.5, 0.2), 1.5, 0.7}};
}

enum class Kind { rectangle, polygon, disk, ball, sun, segment, even_segment };
constexpr Kind kKinds[] = {Kind::rectangle, Kind::polygon, Kind::disk,        Kind::ball,
                           Kind::sun,       Kind::segment, Kind::even_segment};

PreparedLight light_at(const Place& place, Kind kind) {
  Light light;
  light.color = glm::vec3(1.0f);
  light.intensity = 1.0f;
  light.position = place.distance * place.towards;
  light.direction = -glm::normalize(place.towards + glm::dvec3(0.3, 0.2, 0.1));
  const glm::dvec3 u = glm::normalize(glm::cross(light.direction, glm::dvec3(0.1, 0.9, 0.3)));
  const glm::dvec3 v = glm::cross(light.direction, u);
  light.half_u = place.size * u;
  light.half_v = 0.5 * place.size * v;
  light.radius = kind == Kind::ball ? 0.5 * place.size : place.size;
  light.angular_diameter_rad = 2.0 * std::atan(place.size / place.distance);
  switch (kind) {
    case Kind::rectangle:
      light.type = Light::Type::rectangle;
      break;
    case Kind::polygon: {
      light.type = Light::Type::polygon;
      const auto at = [&](double x, double y) {
        return light.position + place.size * (x * u + y * v);
      };
      light.outlines = {
          {at(-1, -1), at(1, -1), at(1, 1), at(0.2, -0.2), at(-0.3, 0.9), at(-1, 0.5)},
          {at(-0.6, -0.6), at(-0.5, -0.3), at(0.1, -0.6)}};
      break;
    }
    case Kind::disk:
      light.type = Light::Type::disk;
      break;
    case Kind::ball:
      light.type = Light::Type::point;
      break;
    case Kind::sun:
      light.type = Light::Type::directional;
      break;
    case Kind::segment:
    case Kind::even_segment:
      light.type = Light::Type::linear;
      break;
  }
  PreparedLight prepared =
      prepare_light(light, kind == Kind::even_segment ? LightRule::published : LightRule::physical);
  prepared.power = glm::vec3(1.0f);
  return prepared;
}

struct Errors {
  double sum = 0.0;
  double worst = 0.0;
  double values = 0.0;
  int count = 0;

  void add(double value, double expected) {
    sum += std::abs(value - expected);
    worst = std::max(worst, std::abs(value - expected));
    values += expected;
    ++count;
  }
  [[nodiscard]] double mean_share() const { return sum / values; }
  [[nodiscard]] double worst_share() const { return worst * count / values; }
};

/// Of one kind of light seen from the angles between two: metals and dielectrics of all roughnesses
/// and lights in all places.
Errors errors_of(Kind kind, double least, double most, glm::dvec3 geometric) {
  const bool flat = kind != Kind::segment && kind != Kind::even_segment;
  const Receiver receiver{glm::dvec3(0.0), up, geometric};
  Errors all;
  for (const double roughness : kRoughnesses) {
    for (const double degrees : kAngles) {
      if (degrees < least || degrees > most) continue;
      const double theta = degrees * pi / 180.0;
      const glm::dvec3 to_viewer = direction(theta, pi);
      const SpecularView view(receiver, to_viewer, roughness);
      const LtcError error = ltc_error(std::cos(theta), roughness);
      const LtcNorms norms = ltc_norms(std::cos(theta), roughness);
      for (const Place& place : places(theta, roughness)) {
        for (const double f0 : {1.0, 0.04}) {
          const PreparedLight light = light_at(place, kind);
          const double expected = oracle(light, receiver, to_viewer, roughness, f0);
          const double value = closed_form(light, view, f0);
          all.add(value, expected);
          // What the table promises of lights of even radiance.
          const double promised = f0 * norms.lobe * (error.lobe + interpolated) +
                                  (1.0 - f0) * norms.fresnel * (error.fresnel + interpolated);
          if (!flat) continue;
          EXPECT_NEAR(value, expected, promised)
              << "roughness " << roughness << ", " << degrees << " degrees, f0 " << f0;
        }
      }
    }
  }
  return all;
}

TEST(SpecularIntegral, AgreesWithQuadratureForAllKindsOfLights) {
  for (const Kind kind : kKinds) {
    const std::string at = "kind " + std::to_string(static_cast<int>(kind));
    const Errors steep = errors_of(kind, 0.0, 60.0, up);
    EXPECT_LT(steep.mean_share(), 0.006) << at;
    EXPECT_LT(steep.worst_share(), 0.095) << at;
    const Errors flat = errors_of(kind, 70.0, 80.0, up);
    EXPECT_LT(flat.mean_share(), 0.018) << at;
    EXPECT_LT(flat.worst_share(), 0.21) << at;
  }
}

// The surface's own horizon cuts lights that its shading normal sees whole.
TEST(SpecularIntegral, AgreesWithQuadratureAboveBothHorizons) {
  for (const Kind kind : kKinds) {
    const Errors cut = errors_of(kind, 40.0, 60.0, glm::normalize(glm::dvec3(-0.6, 0.2, 0.5)));
    EXPECT_LT(cut.mean_share(), 0.03) << static_cast<int>(kind);
    EXPECT_GT(cut.values, 0.1);
  }
}

TEST(SpecularIntegral, OfAPointIsTheBrdf) {
  const Receiver receiver{{1, 2, 3}, up, up};
  const glm::dvec3 v = direction(0.9, 2.0);
  Light light;
  light.position = {1.5, 3.0, 5.0};
  light.intensity = 7.0f;
  const glm::dvec3 to_light = light.position - receiver.position;
  const glm::dvec3 l = glm::normalize(to_light);
  for (const double roughness : {0.25, 0.5, 1.0}) {
    const SpecularView view(receiver, v, roughness);
    for (const double f0 : {0.04, 1.0}) {
      const double brdf = brdf_of(up, v, l, roughness, f0);
      const double expected = brdf * l.z / glm::dot(to_light, to_light);
      EXPECT_NEAR(closed_form(prepare_light(light), view, f0), expected, 1e-4 * expected);
      Light distant;
      distant.type = Light::Type::directional;
      distant.direction = -l;
      EXPECT_NEAR(closed_form(prepare_light(distant), view, f0), brdf * l.z, 1e-4 * brdf);
    }
  }
  light.range = 4.0;
  const PreparedLight ranged = prepare_light(light);
  light.range = 0.0;
  const SpecularView view(receiver, v, 0.5);
  EXPECT_NEAR(specular_of(ranged, view).lobe,
              specular_of(prepare_light(light), view).lobe * attenuation(ranged, receiver.position),
              1e-12);
  EXPECT_LT(attenuation(ranged, receiver.position), 0.9);
}

/// Six squares that face the middle of a cube of half the side `size` around `middle`.
std::vector<PreparedLight> box_of_lights(glm::dvec3 middle, double size) {
  std::vector<PreparedLight> lights;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Light light;
      light.type = Light::Type::rectangle;
      glm::dvec3 out(0.0);
      out[axis] = side;
      light.position = middle + size * out;
      light.direction = -out;
      light.half_u = light.half_v = glm::dvec3(0.0);
      light.half_u[(axis + 1) % 3] = size;
      light.half_v[(axis + 2) % 3] = size;
      lights.push_back(prepare_light(light));
    }
  }
  return lights;
}

TEST(SpecularIntegral, OfLightsAllAroundIsTheLobesNorm) {
  test::RandomSpace random(3);
  for (int round = 0; round < 40; ++round) {
    const double roughness = random.between(0.1, 1.0);
    const glm::dvec3 n = random.direction();
    glm::dvec3 v = random.direction();
    if (glm::dot(n, v) < 0.0) v = -v;
    const bool bent = round % 2 == 1;
    const glm::dvec3 g = bent ? glm::normalize(n + 0.6 * random.direction()) : n;
    const glm::dvec3 place = 3.0 * random.direction();
    const SpecularView view({place, n, g}, v, roughness);
    Light ball;
    ball.position = place + 0.3 * random.direction();
    ball.radius = 0.5;
    const SpecularIntegral inside = specular_of(prepare_light(ball), view);
    SpecularIntegral sum;
    const double size = std::pow(10.0, random.between(-3.0, 3.0));
    for (const PreparedLight& light :
         box_of_lights(place + 0.4 * size * random.direction(), size)) {
      const SpecularIntegral one = specular_of(light, view);
      sum.lobe += one.lobe;
      sum.fresnel += one.fresnel;
    }
    EXPECT_NEAR(sum.lobe, inside.lobe, 1e-9) << round;
    EXPECT_NEAR(sum.fresnel, inside.fresnel, 1e-9) << round;
    const LtcNorms norms = ltc_norms(glm::dot(n, v), roughness);
    if (bent) {
      EXPECT_LT(inside.lobe, norms.lobe) << round;
    } else {
      EXPECT_NEAR(inside.lobe, norms.lobe, 1e-9) << round;
      EXPECT_NEAR(inside.fresnel, norms.fresnel, 1e-9) << round;
    }
  }
}

TEST(SpecularIntegral, HolesAreLeftOutAndBacksAreDark) {
  const Receiver receiver{glm::dvec3(0.0), up, up};
  const SpecularView view(receiver, direction(0.5, pi), 0.4);
  const auto square = [](double half) {
    return std::vector<glm::dvec3>{{0.5 - half, -half, 1},
                                   {0.5 + half, -half, 1},
                                   {0.5 + half, half, 1},
                                   {0.5 - half, half, 1}};
  };
  Light light;
  light.type = Light::Type::polygon;
  light.direction = {0, 0, -1};
  light.outlines = {square(0.5), square(0.3)};
  const double holed = specular_of(prepare_light(light), view).lobe;
  light.outlines = {square(0.5)};
  const double all = specular_of(prepare_light(light), view).lobe;
  light.outlines = {square(0.3)};
  const double hole = specular_of(prepare_light(light), view).lobe;
  EXPECT_NEAR(holed, all - hole, 1e-12);
  EXPECT_GT(holed, 0.05 * all);
  light.direction = {0, 0, 1};
  EXPECT_EQ(specular_of(prepare_light(light), view).lobe, 0.0);
  light.two_sided = true;
  EXPECT_NEAR(specular_of(prepare_light(light), view).lobe, hole, 1e-12);
}

TEST(SpecularIntegral, DoesNotDependOnUnits) {
  for (const Kind kind : kKinds) {
    const Place place{direction(0.7, 0.1), 2.0, 0.6};
    const SpecularIntegral one = specular_of(
        light_at(place, kind), SpecularView({glm::dvec3(0.0), up, up}, direction(0.6, pi), 0.3));
    for (const double unit : {1e-6, 1e6}) {
      const SpecularIntegral other =
          specular_of(light_at({place.towards, unit * place.distance, unit * place.size}, kind),
                      SpecularView({glm::dvec3(0.0), up, up}, direction(0.6, pi), 0.3));
      // What a metre of a line gives goes with the distance.
      const bool line = kind == Kind::segment || kind == Kind::even_segment;
      EXPECT_NEAR(other.lobe * (line ? unit : 1.0), one.lobe, 1e-6 * one.lobe);
      EXPECT_NEAR(other.fresnel * (line ? unit : 1.0), one.fresnel, 1e-6 * one.fresnel);
      EXPECT_GT(one.lobe, 0.0);
    }
  }
}

TEST(SpecularIntegral, IsFiniteWhereverTheReceiverIs) {
  test::RandomSpace random(4);
  for (const Kind kind : kKinds) {
    const PreparedLight light = light_at({up, 1.0, 0.5}, kind);
    std::vector<glm::dvec3> positions{light.position,
                                      light.position + light.half_u,
                                      light.position + 2.0 * light.half_u,
                                      light.position + 1e-9 * light.towards,
                                      light.position + light.half_u + 1e-12 * light.towards,
                                      glm::dvec3(1e12, 0, 0)};
    for (const glm::dvec3& position : positions) {
      for (int round = 0; round < 20; ++round) {
        const Receiver receiver{position, random.direction(), random.direction()};
        const SpecularView view(receiver, random.direction(), random.between(0.0, 1.2));
        const SpecularIntegral all = specular_of(light, view);
        EXPECT_TRUE(std::isfinite(all.lobe) && std::isfinite(all.fresnel));
        EXPECT_GE(all.lobe, 0.0);
        EXPECT_GE(all.fresnel, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace asos::specular_integral_test
