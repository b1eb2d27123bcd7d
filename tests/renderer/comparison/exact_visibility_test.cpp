#include "renderer/comparison/exact_visibility.h"

#include "renderer/comparison/method.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_settings.h"
#include "tests/support/polygon.h"
#include "tests/support/polygon_scene.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace asos::test::exact_visibility_test {
namespace {

using Corners = std::array<glm::dvec3, 3>;

// Corners are double here, so that closed forms hold to that precision.
glm::dvec3 at(double u, double v, double depth) {
  return glm::dvec3(u, -v, -1.0) * depth;
}

/// Triangles seen through the unit square.
class Seen {
 public:
  explicit Seen(const std::vector<Corners>& triangles, const Frame& frame = unit_frame(),
                const FrameRectangle& rectangle = {}) {
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      if (const auto facet = make_facet(frame, i, triangles[i])) facets.push_back(*facet);
    const auto found = visibility_.find(facets, rectangle);
    parts.assign(found.begin(), found.end());
    areas.resize(triangles.size());
    for (const VisiblePart& part : parts) {
      total += part.area;
      if (part.facet == VisiblePart::background) {
        background += part.area;
      } else {
        areas[facets[part.facet].triangle] += part.area;
      }
    }
  }

  std::vector<Facet> facets;
  std::vector<VisiblePart> parts;
  std::vector<double> areas;  ///< of each triangle
  double background = 0.0;
  double total = 0.0;

 private:
  ExactVisibility visibility_;
};

void add_fan(std::vector<Corners>& triangles, const std::vector<glm::dvec3>& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

double sum(const std::vector<double>& values, std::size_t first, std::size_t count) {
  double total = 0.0;
  for (std::size_t i = first; i < first + count; ++i) total += values[i];
  return total;
}

TEST(ExactVisibility, NothingIsAllBackground) {
  const Seen seen({});
  EXPECT_EQ(seen.parts.size(), 1u);
  EXPECT_DOUBLE_EQ(seen.background, 1.0);
}

TEST(ExactVisibility, HalfPlanesWedgesAndSliversHaveTheirAreas) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto polygons = [&](int kind) -> Polygon {
    const double angle = unit(random) * 2.0 * std::numbers::pi;
    const glm::dvec2 d(std::cos(angle), std::sin(angle)), n(-d.y, d.x);
    const glm::dvec2 p(unit(random), unit(random));
    if (kind == 0) return {p - 4.0 * d, p + 4.0 * d, p + 4.0 * (d + n), p + 4.0 * (n - d)};
    if (kind == 1)
      return {p, p + 4.0 * d, p + 4.0 * (d + (2.0 * unit(random) - 0.5) * n + 0.1 * n)};
    const glm::dvec2 w = 0.0005 * n;
    return {p - 4.0 * d - w, p + 4.0 * d - w, p + 4.0 * d + w, p - 4.0 * d + w};
  };
  for (int i = 0; i < 3000; ++i) {
    const Polygon polygon = polygons(i % 3);
    std::vector<glm::dvec3> corners;
    const double depth = 1.0 + 9.0 * unit(random);
    for (const glm::dvec2& c : polygon) corners.push_back(at(c.x, c.y, depth));
    std::vector<Corners> triangles;
    add_fan(triangles, corners);
    const Seen seen(triangles);
    const double truth = area(clip_to_unit_square(polygon));
    ASSERT_NEAR(sum(seen.areas, 0, triangles.size()), truth, 1e-12) << "case " << i;
    ASSERT_NEAR(seen.total, 1.0, 1e-12) << "case " << i;
  }
}

TEST(ExactVisibility, ATriangleWithinTheSquareKeepsItsAreaAndCentroid) {
  const Seen seen({Corners{at(0.2, 0.3, 2.0), at(0.5, 0.3, 3.0), at(0.2, 0.7, 9.0)}});
  EXPECT_NEAR(seen.areas[0], 0.06, 1e-14);
  EXPECT_NEAR(seen.background, 0.94, 1e-14);
  ASSERT_EQ(seen.parts[0].facet, 0u);
  EXPECT_NEAR(seen.parts[0].centroid.x, 0.3, 1e-14);
  EXPECT_NEAR(seen.parts[0].centroid.y, 1.3 / 3.0, 1e-14);
}

TEST(ExactVisibility, LimitsTheResultToARectangle) {
  const FrameRectangle rectangle{{0.25, 0.5}, {0.5, 0.75}};
  const Seen seen({Corners{at(-1, -1, 2), at(3, -1, 2), at(-1, 1.25, 2)}}, unit_frame(), rectangle);
  // The hypotenuse u * 2.25 + v * 4 = 2.75 crosses v = 0.5 at u = 1 / 3.
  const double foot = 1.0 / 3.0 - 0.25;
  const double rise = foot * 2.25 / 4.0;
  EXPECT_NEAR(seen.areas[0], 0.5 * foot * rise, 1e-14);
  EXPECT_NEAR(seen.total, 0.0625, 1e-14);
}

TEST(ExactVisibility, NearerSurfacesHideFartherOnes) {
  // A square of side 1/2 in front of a wall that fills the right three quarters, in front of a wall
  // that fills everything.
  std::vector<Corners> triangles;
  add_fan(triangles, {at(0, 0, 9), at(1, 0, 9), at(1, 1, 9), at(0, 1, 9)});
  add_fan(triangles, {at(0.25, -1, 5), at(2, -1, 5), at(2, 2, 5), at(0.25, 2, 5)});
  add_fan(triangles, {at(0, 0.25, 2), at(0.5, 0.25, 2), at(0.5, 0.75, 2), at(0, 0.75, 2)});
  const Seen seen(triangles);
  EXPECT_NEAR(sum(seen.areas, 4, 2), 0.25, 1e-13);
  EXPECT_NEAR(sum(seen.areas, 2, 2), 0.75 - 0.125, 1e-13);
  EXPECT_NEAR(sum(seen.areas, 0, 2), 0.25 - 0.125, 1e-13);
  EXPECT_NEAR(seen.background, 0.0, 1e-13);
}

TEST(ExactVisibility, RectanglesThatPassThroughEachOtherMeetInALine) {
  // The depth is 1/q. One rectangle is at depth 2; the other goes from depth 1 at u = 0 to
  // infinity: q = 1 - 0.9 u. They intersect at q = 1/2, u = 5/9.
  std::vector<Corners> triangles;
  const auto tilted = [](double u, double v) { return at(u, v, 1.0 / (1.0 - 0.9 * u)); };
  add_fan(triangles, {at(-1, -1, 2), at(2, -1, 2), at(2, 2, 2), at(-1, 2, 2)});
  add_fan(triangles, {tilted(0, 0.1), tilted(1, 0.1), tilted(1, 0.7), tilted(0, 0.7)});
  const Seen seen(triangles);
  EXPECT_NEAR(sum(seen.areas, 2, 2), 0.6 * 5.0 / 9.0, 1e-13);
  EXPECT_NEAR(sum(seen.areas, 0, 2), 1.0 - 0.6 * 5.0 / 9.0, 1e-13);
  EXPECT_NEAR(seen.background, 0.0, 1e-13);
}

TEST(ExactVisibility, TheLowerOfTwoTrianglesAtOneDepthIsSeen) {
  const Corners a{at(0, 0, 2), at(1, 0, 3), at(0, 1, 5)};
  const Seen twice({a, a, a});
  EXPECT_NEAR(twice.areas[0], 0.5, 1e-14);
  EXPECT_EQ(twice.areas[1] + twice.areas[2], 0.0);
  // Many coplanar overlapping triangles: their union must count once.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-0.5, 1.5);
  std::vector<Corners> triangles;
  const auto on_plane = [&] {
    const double u = unit(random), v = unit(random);
    return at(u, v, 1.0 / (0.7 - 0.1 * u + 0.2 * v));
  };
  for (int i = 0; i < 20; ++i) triangles.push_back({on_plane(), on_plane(), on_plane()});
  const Seen seen(triangles);
  EXPECT_NEAR(seen.total, 1.0, 1e-9);
}

TEST(ExactVisibility, CornersBehindTheApexNeedNoSpecialCase) {
  // The floor is half a unit below the eye and extends far ahead and behind. Looking down -Z at the
  // unit square, v of a floor point at depth d is 0.5 / d.
  std::vector<Corners> floor;
  add_fan(floor, {{-1e7, -0.5, 1e3}, {1e7, -0.5, 1e3}, {1e7, -0.5, -1e6}, {-1e7, -0.5, -1e6}});
  const Seen seen(floor);
  // Visible from the far edge, v = 0.5e-6, downwards.
  EXPECT_NEAR(sum(seen.areas, 0, 2), 1.0 - 0.5e-6, 1e-11);
  EXPECT_NEAR(seen.total, 1.0, 1e-11);
}

TEST(ExactVisibility, IgnoresTrianglesWithoutArea) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Frame frame = unit_frame();
  EXPECT_FALSE(make_facet(frame, 0, {at(0, 0, 1), at(1, 1, 2), at(0.5, 0.5, 3)}));  // edge-on
  EXPECT_FALSE(make_facet(frame, 0, {at(0, 0, 1), at(0, 0, 1), at(1, 1, 1)}));
  EXPECT_FALSE(make_facet(frame, 0, {at(0, 0, 1), at(nan, 0, 1), at(1, 1, 1)}));
  EXPECT_FALSE(make_facet(frame, 0, {at(0, 0, -1), at(1, 0, -1), at(1, 1, -1)}));  // behind
  EXPECT_FALSE(make_facet(frame, 0, {at(2, 0, 1), at(3, 0, 1), at(2, 1, 1)}));     // beside
}

Corners random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Corners corners;
  for (glm::dvec3& c : corners) {
    // Some behind the apex.
    c = at(2.0 * unit(random) - 0.5, 2.0 * unit(random) - 0.5, 1.0 + 4.0 * unit(random));
    if (unit(random) < 0.1) c.z = -c.z;
  }
  return corners;
}

/// Distance of a point from the border of a convex polygon with either winding; negative outside.
double depth_in(const ConvexPolygon& polygon, glm::dvec2 p) {
  double least = 1e9, greatest = -1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 d = polygon[(i + 1) % polygon.size()] - a;
    const double length = glm::length(d);
    if (length < 1e-9) continue;
    const double depth = (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / length;
    least = std::min(least, depth);
    greatest = std::max(greatest, depth);
  }
  return std::max(least, -greatest);
}

std::uint32_t nearest(const World& world, const Frame& frame, glm::dvec2 p) {
  const bool flat = frame.parallel();
  const glm::dvec3 origin = flat ? frame.world({p.x, p.y, 0.0}) : frame.apex();
  const glm::dvec3 direction =
      flat ? frame.direction() : frame.world({p.x, p.y, 1.0}) - frame.apex();
  std::uint32_t best = VisiblePart::background;
  double t = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < world.triangles.size(); ++i) {
    const auto met = crossing(world, i, origin, direction);
    if (met && met->inside() >= 0.0 && met->t > 0.0 && met->t < t) t = met->t, best = i;
  }
  return best;
}

// Each sample of a dense grid is in one part, which shows the surface that the sample's ray hits.
TEST(ExactVisibility, AgreesWithRaysOnRandomSoups) {
  constexpr int n = 64;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    World world;
    std::vector<Corners> triangles;
    for (unsigned i = 0; i < 2 + seed % 24; ++i) {
      Corners corners = random_triangle(random);
      for (glm::dvec3& c : corners) {
        world.positions.emplace_back(c);
        c = glm::dvec3(world.positions.back());
      }
      triangles.push_back(corners);
      world.triangles.push_back(3u * i + glm::uvec3(0, 1, 2));
    }
    const Frame frame =
        seed % 4 == 3 ? Frame::prism({0, 0, 0}, {0, 0, -1}, {2, 0.3, 0}, {0, -2, 0}) : unit_frame();
    const Seen seen(triangles, frame);
    ASSERT_NEAR(seen.total, 1.0, 1e-9) << "seed " << seed;
    int skipped = 0;
    for (int k = 0; k < n * n; ++k) {
      const glm::dvec2 p((k % n + 0.5) / n, (k / n + 0.5) / n);
      int holders = 0;
      bool near_border = false;
      std::uint32_t shown = VisiblePart::background;
      for (const VisiblePart& part : seen.parts) {
        const double depth = depth_in(part.polygon, p);
        near_border |= std::abs(depth) < 1e-9;
        if (depth <= 0.0) continue;
        ++holders;
        if (part.facet != VisiblePart::background) shown = seen.facets[part.facet].triangle;
      }
      skipped += near_border;
      if (near_border) continue;
      ASSERT_EQ(holders, 1) << "seed " << seed << " at " << p.x << ", " << p.y;
      ASSERT_EQ(shown, nearest(world, frame, p)) << "seed " << seed << " at " << p.x << ", " << p.y;
    }
    // Samples exactly on the grid's lines may lie on a cell's cut.
    ASSERT_LT(skipped, n * n / 100) << "seed " << seed;
  }
}

TEST(ExactVisibility, ManyTrianglesAddUpToTheSquare) {
  std::mt19937 random(7);
  std::vector<Corners> triangles;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec2 c(unit(random), unit(random));
    Corners corners;
    for (glm::dvec3& p : corners)
      p = at(c.x + 0.2 * unit(random), c.y + 0.2 * unit(random), 1.0 + unit(random));
    triangles.push_back(corners);
  }
  EXPECT_NEAR(Seen(triangles).total, 1.0, 1e-9);
}

// A fan whose triangles all share a corner.
TEST(ExactVisibility, ADiskOfManySegmentsHasItsArea) {
  std::vector<Corners> triangles;
  std::vector<glm::dvec3> corners;
  Polygon disk;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 1000;
    disk.push_back(glm::dvec2(0.5, 0.5) + 0.3 * glm::dvec2(std::cos(angle), std::sin(angle)));
    corners.push_back(at(disk.back().x, disk.back().y, 2.0));
  }
  add_fan(triangles, corners);
  const Seen seen(triangles);
  EXPECT_NEAR(sum(seen.areas, 0, triangles.size()), area(disk), 1e-9);
  EXPECT_NEAR(seen.total, 1.0, 1e-9);
}

BlockResult beam(const RenderScene& scene, const View& view) {
  const RenderSettings settings = make_settings(view.width(), view.height(), Method::beam);
  return render_block(scene, view, settings, {0, 0, view.width(), view.height()});
}

TEST(Beam, APixelIsAreaTimesRadiance) {
  World world;
  add_quad(world, {-3.3f, -9, 0}, {3, 0, 0}, {0, 18, 0}, unlit({1, 1, 1}));
  add_quad(world, {-9, -9, -2}, {18, 0, 0}, {0, 12.75f, 0}, unlit({0.5f, 0, 0}));
  const auto scene = make_render_scene(std::move(world));
  const BlockResult r = beam(*scene, View(orthographic(8.0), 8, 8));
  ASSERT_EQ(r.tile.radiance.size(), 64u);
  // Pixel (3, 0): white up to x = -0.3; below y = 3.75 red, above it sky.
  const glm::vec3 behind = 0.75f * glm::vec3(0.5f, 0, 0) + 0.25f * background_radiance;
  const glm::vec3 expected = 0.7f * glm::vec3(1) + 0.3f * behind;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(r.tile.radiance[3][k], expected[k], 1e-6);
  EXPECT_EQ(r.tile.split_level[3], 1);
  EXPECT_EQ(r.tile.radiance[8 * 7 + 7], glm::vec3(0.5f, 0, 0));
}

TEST(Beam, ShadesAsRaysDo) {
  // Without shadows, whose edges beam tracing does not find.
  FlattenedScene still = still_life();
  for (Light& light : still.lights) light.casts_shadows = false;
  const auto scene = make_render_scene(std::move(still));
  const View view(look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), 8, 8);
  const BlockResult exact = beam(*scene, view);
  const RenderSettings settings = make_settings(8, 8, Method::uniform, 64 * 64);
  const BlockResult fine = render_block(*scene, view, settings, {0, 0, 8, 8});
  for (std::size_t i = 0; i < 64; ++i) {
    // The grid's error is up to 1/64 pixel along each edge.
    const double difference = glm::length(exact.tile.radiance[i] - fine.tile.radiance[i]);
    EXPECT_LT(difference, 1.0 / 64.0) << "pixel " << i;
  }
  EXPECT_EQ(exact.statistics.rejected_samples, 0u);
}

TEST(Beam, RefusesLargeScenesWithAReason) {
  World world;
  add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, unlit({1, 1, 1}));
  const auto geometry = std::make_shared<Geometry>();
  geometry->world = std::move(world);
  const auto scene = unedited_scene(geometry, {});
  RenderSettings settings;
  settings.method = Method::beam;
  EXPECT_TRUE(check_method(*scene, settings).has_value());
  geometry->world.triangles.resize(most_beam_triangles + 1);
  const auto refused = check_method(*scene, settings);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().subject, "method");
  EXPECT_NE(refused.error().reason.find(std::to_string(most_beam_triangles + 1)),
            std::string::npos);
  settings.method = Method::asos;
  EXPECT_TRUE(check_method(*scene, settings).has_value());
}

}  // namespace
}  // namespace asos::test::exact_visibility_test
