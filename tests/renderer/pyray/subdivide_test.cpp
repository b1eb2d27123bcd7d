#include "renderer/pyray/subdivide.h"

#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asos::test {
namespace {

TEST(Subdivide, AnEmptyPixelTakesOneSample) {
  PolygonScene scene;
  add_polygon(scene, {{3, 3}, {4, 3}, {4, 4}}, 2.0);
  const Answer answer = subdivide(scene.world, rules_of(4));
  EXPECT_EQ(answer.probes, 1);
  EXPECT_DOUBLE_EQ(answer.total, 1.0);
  EXPECT_EQ(answer.outcome.deepest, 0);
}

TEST(Subdivide, HalfPlanesAreExactAtEveryLevel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const auto polygon =
        half_plane({unit(random), unit(random)}, unit(random) * 2.0 * std::numbers::pi);
    PolygonScene scene;
    add_polygon(scene, polygon, 1.0 + 9.0 * unit(random));
    const double truth = area(clip_to_unit_square(polygon));
    const Answer answer = subdivide(scene.world, rules_of(1 + i % 4));
    ASSERT_NEAR(answer.coverage[0], truth, 1e-5) << "case " << i;
    ASSERT_NEAR(answer.total, 1.0, 1e-9) << "case " << i;
  }
}

TEST(Subdivide, SliversAreNeverLost) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const double width : {1.0 / 50.0, 1.0 / 1000.0}) {
    for (int i = 0; i < 500; ++i) {
      const double angle = unit(random) * 2.0 * std::numbers::pi;
      const glm::dvec2 d(std::cos(angle), std::sin(angle));
      const glm::dvec2 n = 0.5 * width * glm::dvec2(-d.y, d.x);
      const glm::dvec2 p(0.2 + 0.6 * unit(random), 0.2 + 0.6 * unit(random));
      const std::vector<glm::dvec2> polygon{p - 4.0 * d - n, p + 4.0 * d - n, p + 4.0 * d + n,
                                            p - 4.0 * d + n};
      PolygonScene scene;
      add_polygon(scene, polygon, 3.0);
      const double truth = area(clip_to_unit_square(polygon));
      const Answer answer = subdivide(scene.world, rules_of(4));
      ASSERT_NEAR(answer.coverage[0], truth, 0.01 * truth) << "width " << width << " case " << i;
    }
  }
}

TEST(Subdivide, SmallTrianglesInsideAPixelKeepTheirArea) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 centre(0.1 + 0.8 * unit(random), 0.1 + 0.8 * unit(random));
    std::vector<glm::dvec2> polygon;
    for (int k = 0; k < 3; ++k)
      polygon.push_back(centre + 0.1 * glm::dvec2(unit(random) - 0.5, unit(random) - 0.5));
    PolygonScene scene;
    add_polygon(scene, polygon, 2.0);
    const double truth = area(clip_to_unit_square(polygon));
    if (truth < 1e-5) continue;
    ASSERT_NEAR(subdivide(scene.world, rules_of(4)).coverage[0], truth, 1e-5) << "case " << i;
  }
}

// Two overlapping half-planes at different depths: the far one is visible where the near one does
// not cover it.
TEST(Subdivide, HiddenSurfacesDoNotCount) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const auto near = half_plane({unit(random), unit(random)}, unit(random) * 6.3);
    const auto far = half_plane({unit(random), unit(random)}, unit(random) * 6.3);
    PolygonScene scene;
    add_polygon(scene, far, 5.0);
    add_polygon(scene, near, 2.0);
    // Visible area of the far half-plane: its area minus the overlap, by clipping.
    std::vector<glm::dvec2> both = clip_to_unit_square(far);
    const double far_area = area(both);
    std::vector<glm::dvec2> kept;
    const glm::dvec2 a = near[0], b = near[1];
    const auto side = [&](glm::dvec2 q) {
      return (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
    };
    for (std::size_t k = 0; k < both.size(); ++k) {
      const glm::dvec2 q = both[k], r = both[(k + 1) % both.size()];
      if (side(q) >= 0) kept.push_back(q);
      if ((side(q) < 0) != (side(r) < 0))
        kept.push_back(q + (r - q) * (side(q) / (side(q) - side(r))));
    }
    const Answer answer = subdivide(scene.world, rules_of(5));
    ASSERT_NEAR(answer.coverage[1], area(clip_to_unit_square(near)), 1e-5) << "case " << i;
    ASSERT_NEAR(answer.coverage[0], far_area - area(kept), 1e-5) << "case " << i;
  }
}

TEST(Subdivide, AWallHidesAllBehindIt) {
  PolygonScene scene;
  add_polygon(scene, {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}, 1.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 c(unit(random), unit(random));
    add_polygon(scene, {c, c + glm::dvec2(0.1, 0.0), c + glm::dvec2(0.0, 0.1)}, 20.0 + i);
  }
  const Answer answer = subdivide(scene.world, rules_of(4));
  EXPECT_DOUBLE_EQ(answer.coverage[0], 1.0);
  EXPECT_EQ(answer.outcome.deepest, 0);
  EXPECT_EQ(answer.probes, 1);
}

TEST(Subdivide, ADiskOfManySegmentsHasItsArea) {
  PolygonScene scene;
  std::vector<glm::dvec2> disk;
  const int n = 10000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    disk.push_back(glm::dvec2(0.5, 0.5) + 0.3 * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  add_polygon(scene, disk, 2.0);
  const double truth = area(disk);
  // The outline is one chain, simplified to within 1/64 of a cell at the finest level, and more
  // closely in larger cells. A chord cuts off two thirds of its arc's height times its length.
  const double finest = 1.0 / 64.0;
  const Answer answer = subdivide(scene.world, rules_of(6));
  EXPECT_EQ(answer.outcome.unresolved_area, 0.0);
  EXPECT_NEAR(answer.coverage[0], truth,
              2.0 / 3.0 * finest / 64.0 * 2.0 * std::numbers::pi * 0.3 + 1e-6);
}

TEST(Subdivide, OrthographicFramesAreExactToo) {
  const auto polygon = half_plane({0.4, 0.6}, 0.7);
  PolygonScene scene;
  std::vector<glm::vec3> points;
  for (const glm::dvec2& c : polygon) points.emplace_back(c.x, -c.y, -3.0);
  scene.add(points);
  const Frame frame = Frame::prism({0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0});
  const Answer answer = subdivide(scene.world, rules_of(2), {frame});
  EXPECT_NEAR(answer.coverage[0], area(clip_to_unit_square(polygon)), 1e-6);
}

TEST(Subdivide, MaxZeroTakesOneSampleWithPointLeaves) {
  PolygonScene scene;
  add_polygon(scene, half_plane({0.5, 0.4}, 0.3), 2.0);
  const Answer answer = subdivide(scene.world, rules_of(0, 0.0, false));
  EXPECT_EQ(answer.probes, 1);
  EXPECT_DOUBLE_EQ(answer.total, 1.0);
  EXPECT_DOUBLE_EQ(answer.outcome.unresolved_area, 1.0);
}

TEST(Subdivide, ASphereMeshShowsItsSilhouetteWhateverItsWinding) {
  for (const bool scrambled : {false, true}) {
    PolygonScene scene;
    Part part;
    part.triangle_count = 0;
    const int rings = 16, sectors = 32;
    const glm::vec3 centre = at_depth(0.5, 0.5, 4.0);
    for (int r = 0; r <= rings; ++r) {
      for (int s = 0; s < sectors; ++s) {
        const double theta = std::numbers::pi * r / rings,
                     phi = 2.0 * std::numbers::pi * s / sectors;
        const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                          std::sin(theta) * std::sin(phi));
        scene.world.normals.push_back(n);
        scene.world.positions.push_back(centre + 1.2f * (r == 0       ? glm::vec3(0, 1, 0)
                                                         : r == rings ? glm::vec3(0, -1, 0)
                                                                      : n));
      }
    }
    std::mt19937 random(8);
    for (int r = 0; r < rings; ++r) {
      for (int s = 0; s < sectors; ++s) {
        const auto at = [&](int i, int j) {
          return static_cast<std::uint32_t>(i * sectors + j % sectors);
        };
        for (glm::uvec3 t : {glm::uvec3(at(r, s), at(r + 1, s), at(r + 1, s + 1)),
                             glm::uvec3(at(r, s), at(r + 1, s + 1), at(r, s + 1))}) {
          if (scrambled && random() % 2) std::swap(t.y, t.z);
          scene.world.triangles.push_back(t);
          scene.world.triangle_part.push_back(0);
        }
      }
    }
    scene.world.parts.push_back(part);
    scene.world.materials[0].double_sided = true;
    const FeatureSet features(scene.world);
    EXPECT_EQ(features.counts().open, 0u);
    EXPECT_EQ(features.counts().crease, 0u);
    // Reference: dense regular samples.
    const Frame frame = unit_frame();
    BruteForceCaster truth(scene.world, features, frame);
    const int n = 200;
    std::vector<glm::vec2> points;
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        points.emplace_back((static_cast<float>(x) + 0.5f) / n, (static_cast<float>(y) + 0.5f) / n);
    const SampleId first = truth.probe(points);
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const PyrayLeaf leaf{0, first + i, 1.0 / (n * n), {}};
      truth.take(std::span(&leaf, 1));
    }
    const Answer answer = subdivide(scene.world, rules_of(5));
    EXPECT_NEAR(answer.coverage[0], truth.coverage[0], 1e-3) << "scrambled " << scrambled;
    EXPECT_LT(answer.probes, 600) << "scrambled " << scrambled;
  }
}

}  // namespace
}  // namespace asos::test
