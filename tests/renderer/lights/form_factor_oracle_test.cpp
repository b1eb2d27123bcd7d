#include "renderer/lights/form_factor.h"
#include "tests/support/light_oracle.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// Closed forms against quadrature, for lights of all sizes and receivers of all kinds.

namespace asos::form_factor_oracle_test {
namespace {

using Outlines2 = std::vector<std::vector<glm::dvec2>>;

constexpr int kRounds = 60;
const double kSizes[] = {1e-4, 1e-2, 0.3, 1.0, 3.0, 100.0, 1e4};  // sizes at a distance of about 1

/// Relative error 1e-5. Smaller forms have the rounding error of a contour's sides, which are up to
/// 1.
void expect_form(double form, double expected, double size, int round) {
  EXPECT_NEAR(form, expected, 1e-5 * expected + 1e-14) << "size " << size << ", round " << round;
}

/// Number of nonzero cases: a test with only unlit receivers would prove nothing.
struct Lit {
  int lit = 0;
  int all = 0;

  void count(double expected) {
    ++all;
    if (expected > 0.0) ++lit;
  }
  ~Lit() { EXPECT_GT(lit, all / 2); }
};

/// A plane and a receiver above a point on it or next to it. Every fifth receiver is very close to
/// the plane, except for lights so large that rounding of their corners matters.
struct FlatCase {
  FlatCase(test::RandomSpace& random, double size, int round)
      : facing(random.direction()),
        u(random.perpendicular(facing)),
        v(glm::cross(facing, u)),
        centre(random.direction() * random.between(0.0, 1.0)) {
    const double height = round % 5 == 0 && size < 1e3 ? std::pow(10.0, random.between(-4.0, 0.0))
                                                       : random.between(0.1, 1.0);
    const glm::dvec3 over =
        centre + size * (random.between(-1.2, 1.2) * u + random.between(-1.2, 1.2) * v);
    const glm::dvec3 position = over + height * facing +
                                std::sqrt((1.0 - height) * (1.0 + height)) *
                                    random.between(0.0, 1.0) * random.perpendicular(facing);
    receiver = random.receiver(position, centre + 0.5 * size * random.direction(), round);
  }

  [[nodiscard]] std::vector<glm::dvec3> placed(const std::vector<glm::dvec2>& outline) const {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& p : outline) corners.push_back(centre + p.x * u + p.y * v);
    return corners;
  }

  glm::dvec3 facing, u, v, centre;
  Receiver receiver;
};

/// Calls `check(random, size, round)`, which returns the expected form, for each size and round.
template <typename Check>
void each_case(unsigned seed, const Check& check) {
  test::RandomSpace random(seed);
  Lit lit;
  for (int round = 0; round < kRounds; ++round)
    for (const double size : kSizes) lit.count(check(random, size, round));
}

double outlines_form(const FlatCase& flat, const Outlines2& outlines) {
  double form = 0.0;
  for (const auto& outline : outlines) form += polygon_form(flat.placed(outline), flat.receiver);
  return form;
}

TEST(FormFactorOracle, AgreesOnRectangles) {
  each_case(1, [](test::RandomSpace& random, double size, int round) {
    const FlatCase flat(random, size, round);
    const double h = size * std::pow(10.0, random.between(-2.0, 0.0));
    const Outlines2 outlines{{{-size, -h}, {size, -h}, {size, h}, {-size, h}}};
    const double expected = test::flat_oracle(
        test::polygon_region(flat.centre, flat.u, flat.v, outlines), flat.receiver);
    expect_form(outlines_form(flat, outlines), expected, size, round);
    return expected;
  });
}

TEST(FormFactorOracle, AgreesOnConcavePolygonsWithHoles) {
  each_case(2, [](test::RandomSpace& random, double size, int round) {
    const FlatCase flat(random, size, round);
    Outlines2 outlines{{{-1, -1}, {1, -1}, {1, 1}, {0.2, -0.2}, {-0.3, 0.9}, {-1, 0.5}},
                       {{-0.6, -0.6}, {-0.5, -0.3}, {0.1, -0.6}}};
    for (auto& outline : outlines) {
      for (glm::dvec2& corner : outline) corner *= size;
    }
    const double expected = test::flat_oracle(
        test::polygon_region(flat.centre, flat.u, flat.v, outlines), flat.receiver);
    expect_form(outlines_form(flat, outlines), expected, size, round);
    return expected;
  });
}

TEST(FormFactorOracle, AgreesOnDisks) {
  each_case(3, [](test::RandomSpace& random, double size, int round) {
    const FlatCase flat(random, size, round);
    const double expected =
        test::flat_oracle(test::disk_region(flat.centre, flat.u, flat.v, size), flat.receiver);
    expect_form(disk_form(flat.centre, flat.facing, size, flat.receiver), expected, size, round);
    return expected;
  });
}

TEST(FormFactorOracle, AgreesOnBalls) {
  each_case(4, [](test::RandomSpace& random, double size, int round) {
    const glm::dvec3 centre = random.direction();
    const double gap = round % 5 == 0 ? std::pow(10.0, random.between(-4.0, 0.0)) : 1.0;
    const glm::dvec3 position = centre + (size + gap) * random.direction();
    const Receiver receiver =
        random.receiver(position, centre + 0.9 * size * random.direction(), round);
    const glm::dvec3 to_centre = centre - position;
    const double distance = glm::length(to_centre);
    const double expected =
        test::cone_oracle(to_centre / distance, std::asin(size / distance), receiver);
    expect_form(ball_form(centre, size, receiver), expected, size, round);
    return expected;
  });
}

TEST(FormFactorOracle, AgreesOnLines) {
  each_case(5, [](test::RandomSpace& random, double size, int round) {
    const glm::dvec3 half = size * random.direction();
    const glm::dvec3 centre = random.direction();
    const double height = round % 5 == 0 ? std::pow(10.0, random.between(-3.0, 0.0)) : 1.0;
    const glm::dvec3 position =
        centre + random.between(-1.5, 1.5) * half + height * random.perpendicular(half / size);
    const Receiver receiver =
        random.receiver(position, centre + random.between(-1.0, 1.0) * half, round);
    double lit = 0.0;
    for (const bool lambertian : {false, true}) {
      const double expected = test::line_oracle(centre - half, centre + half, lambertian, receiver);
      expect_form(line_form(centre - half, centre + half, lambertian, receiver), expected, size,
                  round);
      lit += expected;
    }
    return lit;
  });
}

}  // namespace
}  // namespace asos::form_factor_oracle_test
