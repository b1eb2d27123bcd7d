#include "tests/support/polygon_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The engine against the exact reference, for seeded random polygons in one pixel. A failure prints
// its seed and polygons. Each class of cases has the bound that the engine guarantees for it; the
// stopping rules' guarantees are in stopping_rules_test.cpp.

namespace asos::test {
namespace {

TEST(EngineAgainstOracle, HalfPlanesAreExact) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    c.add_half_plane(c.between(1, 10));
    const Answer answer = subdivide(c.world(), rules_of(1 + static_cast<int>(seed % 6)));
    errors.check(c, error_of(answer, by_oracle(c.world())), rounding, answer);
  }
}

TEST(EngineAgainstOracle, WedgesStayBelowTheFinestCell) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    c.add_wedge(c.between(1, 10));
    const int max = 1 + static_cast<int>(seed % 6);
    const Answer answer = subdivide(c.world(), rules_of(max));
    errors.check(c, error_of(answer, by_oracle(c.world())), std::ldexp(1.0, -2 * max) + rounding,
                 answer);
  }
}

// A curved outline of a few segments that crosses the pixel or is inside it.
TEST(EngineAgainstOracle, ChainsStayBelowTheFinestCell) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    c.add_disk(8, c.between(1, 10));
    const int max = 1 + static_cast<int>(seed % 6);
    const Answer answer = subdivide(c.world(), rules_of(max));
    errors.check(c, error_of(answer, by_oracle(c.world())), std::ldexp(1.0, -2 * max) + rounding,
                 answer);
  }
}

void slivers(double width) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    c.add_sliver(width, c.between(1, 10));
    const auto truth = by_oracle(c.world());
    const Answer answer = subdivide(c.world(), rules_of(4));
    errors.check(c, error_of(answer, truth) / truth[0], 0.01, answer);
  }
}
TEST(EngineAgainstOracle, SliversOfAFiftiethKeepTheirArea) {
  slivers(1.0 / 50.0);
}
TEST(EngineAgainstOracle, SliversOfAThousandthKeepTheirArea) {
  slivers(1.0 / 1000.0);
}

TEST(EngineAgainstOracle, SmallTrianglesKeepTheirArea) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    c.add_triangle(0.1, c.between(1, 10));
    const Answer answer = subdivide(c.world(), rules_of(4));
    errors.check(c, error_of(answer, by_oracle(c.world())), std::ldexp(1.0, -8), answer);
  }
}

// A disk of 10,000 segments, radius 1 and depth 2, seen through pixels of random size and position,
// against the closed form: the exact reference would take minutes.
TEST(EngineAgainstOracle, DisksOfManySegmentsStayBelowTheFinestCell) {
  Polygon disk;
  for (int i = 0; i < 10000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 10000;
    disk.emplace_back(std::cos(angle), std::sin(angle));
  }
  PolygonScene scene;
  add_parallel_polygon(scene, disk, 2.0);
  const FeatureSet features(scene.world);
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    const glm::dvec2 centre = c.point();
    const double radius = c.between(0.1, 0.5);  // in pixels
    const double half_side = 0.5 / radius;      // of the pixel at depth 1
    const Pyray pixel{Frame::pyramid({0, 0, 0}, {-half_side * centre.x, half_side * centre.y, -1.0},
                                     {half_side, 0, 0}, {0, -half_side, 0})};
    Polygon seen;
    for (const glm::dvec2& p : disk) seen.push_back(centre + radius * p);
    const int max = 1 + static_cast<int>(seed % 6);
    const Answer answer = subdivide(scene.world, features, rules_of(max), pixel);
    errors.check(c, std::abs(answer.coverage[0] - area(clip_to_unit_square(seen))),
                 std::ldexp(1.0, -2 * max) + rounding, answer);
  }
}

/// Scenes of several surfaces: the unresolved area limits the error of each surface's area.
void several(void (*build)(Case&)) {
  Errors errors;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Case c(seed);
    build(c);
    const Answer answer = subdivide(c.world(), rules_of(1 + static_cast<int>(seed % 6)));
    errors.check(c, error_of(answer, by_oracle(c.world())),
                 answer.outcome.unresolved_area + rounding, answer);
  }
}

TEST(EngineAgainstOracle, TwoCrossingEdges) {
  several([](Case& c) {
    c.add_half_plane(c.between(1, 3));
    c.add_half_plane(c.between(3, 10));
  });
}
TEST(EngineAgainstOracle, ThreeCrossingEdges) {
  several([](Case& c) {
    c.add_half_plane(c.between(1, 2));
    c.add_half_plane(c.between(3, 5));
    c.add_half_plane(c.between(6, 10));
  });
}
TEST(EngineAgainstOracle, HiddenEdgesBehind) {
  several([](Case& c) {
    c.add_half_plane(c.between(1, 2));
    for (int i = 0; i < 6; ++i) c.add_triangle(0.6, c.between(12, 30));
  });
}
TEST(EngineAgainstOracle, EdgesInFrontOfHiddenOnes) {
  several([](Case& c) {
    for (int i = 0; i < 3; ++i) c.add_triangle(0.6, c.between(1, 2));
    c.add_half_plane(c.between(12, 30));
  });
}
// Depths so close to each other that the tolerance of covers decides.
TEST(EngineAgainstOracle, EdgesAtNearDepths) {
  several([](Case& c) {
    for (int i = 0; i < 4; ++i) c.add_triangle(0.8, c.between(2, 2.2));
  });
}
TEST(EngineAgainstOracle, EverythingAtOnce) {
  several([](Case& c) {
    c.add_half_plane(c.between(8, 9));
    c.add_wedge(c.between(5, 7));
    c.add_sliver(0.02, c.between(3, 4));
    for (int i = 0; i < 3; ++i) c.add_triangle(0.5, c.between(1, 3));
  });
}

}  // namespace
}  // namespace asos::test
