#include "renderer/pyray/hit_list.h"

#include "tests/support/polygon_scene.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace asos::test {
namespace {

// Small triangles and a few long ones, anywhere around the apex.
PolygonScene random_scene(std::uint32_t seed, int count) {
  PolygonScene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < count; ++i) {
    const glm::vec3 centre = 5.0f * vector();
    const float size = i % 10 == 0 ? 5.0f : 0.2f;
    scene.add({centre + size * vector(), centre + size * vector(), centre + size * vector()});
  }
  return scene;
}

// Tests every edge against the square, without hierarchy, boxes or lists.
std::set<std::uint32_t> edges_in_square(const FeatureSet& features, const Frame& frame) {
  std::set<std::uint32_t> found;
  for (std::uint32_t e = 0; e < features.edges().size(); ++e) {
    const FeatureEdge& edge = features.edges()[e];
    const glm::dvec3 a = frame.homogeneous(glm::dvec3(features.positions()[edge.a]));
    const glm::dvec3 b = frame.homogeneous(glm::dvec3(features.positions()[edge.b]));
    double t0 = 0.0, t1 = 1.0;
    const auto keep = [&](double f0, double f1) {
      if (f0 < 0.0 && f1 < 0.0) t1 = -1.0;
      if (f0 < 0.0 && f1 >= 0.0) t0 = std::max(t0, f0 / (f0 - f1));
      if (f0 >= 0.0 && f1 < 0.0) t1 = std::min(t1, f0 / (f0 - f1));
    };
    keep(a.x, b.x);
    keep(a.y, b.y);
    keep(a.z - a.x, b.z - b.x);
    keep(a.z - a.y, b.z - b.y);
    if (t1 - t0 > 1e-4) found.insert(e);
  }
  return found;
}

TEST(HitLists, FindEveryEdgeThatCrossesTheSquare) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const PolygonScene scene = random_scene(seed, 500);
    const FeatureSet features(scene.world);
    ASSERT_EQ(features.counts().open, 1500u);
    const Frame frame = unit_frame();
    HitLists lists;
    lists.reset(features, frame, 0.0f);
    // Smaller and smaller cells open all nodes; the union of their lists has all edges in the
    // square.
    std::set<std::uint32_t> found;
    const int n = 64;
    HitLists::List list;
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const Square cell{static_cast<float>(x) / n, static_cast<float>(y) / n, 1.0f / n};
        lists.refine(cell, {}, lists.root(), list);
        for (const std::uint32_t i : list) {
          if (lists.entry(i).is_segment()) {
            found.insert(lists.segment(i).edge);
          } else {
            // Nodes that stay closed are at most a quarter of the cell wide.
            const HitEntry& e = lists.entry(i);
            EXPECT_LE(e.extent(), 0.25f * cell.side);
          }
        }
      }
    }
    for (const std::uint32_t e : edges_in_square(features, frame)) {
      const FeatureEdge& edge = features.edges()[e];
      const FramePoint p =
          frame.project(frame.homogeneous(glm::dvec3(features.positions()[edge.a])));
      EXPECT_TRUE(found.contains(e))
          << "seed " << seed << " edge " << e << " from " << p.u << ", " << p.v;
    }
  }
}

TEST(HitLists, ChildrenNeedOnlyTheirParentsList) {
  const PolygonScene scene = random_scene(99, 2000);
  const FeatureSet features(scene.world);
  HitLists lists;
  lists.reset(features, unit_frame(), 1.0f / 64.0f);
  HitLists::List parent, from_parent, from_root;
  const Square square{0.25f, 0.5f, 0.25f};
  lists.refine(square, {}, lists.root(), parent);
  for (int i = 0; i < 4; ++i) {
    lists.refine(square.quarter(i), {}, parent, from_parent);
    lists.refine(square.quarter(i), {}, lists.root(), from_root);
    // Both lists are cuts through the same tree, so their opened segments must agree.
    std::set<std::uint32_t> a, b;
    for (const std::uint32_t e : from_parent)
      if (lists.entry(e).is_segment()) a.insert(e);
    for (const std::uint32_t e : from_root)
      if (lists.entry(e).is_segment()) b.insert(e);
    EXPECT_EQ(a, b);
  }
}

// Thousands of open edges across the whole square, such as those of points as wide as a pixel, all
// in front of the sampled surface.
TEST(HitLists, ASaturatedCellKeepsNodesClosed) {
  PolygonScene scene;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto corner = [&] {
    return at_depth(2.0 * unit(random) - 0.5, 2.0 * unit(random) - 0.5, 4.0);
  };
  for (int i = 0; i < 4000; ++i) scene.add({corner(), corner(), corner()});
  const FeatureSet features(scene.world);
  const std::set<std::uint32_t> truth = edges_in_square(features, unit_frame());
  ASSERT_GT(truth.size(), 5000u);
  const Square square{0, 0, 1};
  HitLists lists;
  HitLists::List all, list;
  lists.reset(features, unit_frame(), 0.0f);
  lists.refine(square, {}, lists.root(), all);
  EXPECT_EQ(all.size(), truth.size()) << "no surface is known to hide any of them";

  lists.reset(features, unit_frame(), 0.0f);
  lists.refine(square, {}, lists.root(), list, true);
  EXPECT_GT(list.size(), 256u);
  EXPECT_LT(list.size(), 400u);
  // The closed nodes contain all other edges.
  HitLists::List resolved;
  for (const std::uint32_t i : list) ASSERT_TRUE(lists.resolve(i, square, 0.0f, 20000, resolved));
  std::set<std::uint32_t> found;
  for (const std::uint32_t i : resolved) found.insert(lists.segment(i).edge);
  for (const std::uint32_t e : truth) EXPECT_TRUE(found.contains(e)) << e;
}

TEST(HitLists, AClosedSmoothMeshOutOfSilhouetteIsDroppedNearTheRoot) {
  // A finely tessellated dome that fills the square and faces the apex: of thousands of candidates
  // none is an outline, and the search visits a few nodes only.
  PolygonScene scene;
  const int n = 60;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const double u = -1.0 + 3.0 * x / n, v = -1.0 + 3.0 * y / n;
      const double bulge = 0.1 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5));
      scene.world.positions.push_back(at_depth(u, v, 4.0 + bulge));
      scene.world.normals.emplace_back(0, 0, 1);
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
      scene.world.triangles.emplace_back(at(x, y), at(x + 1, y), at(x + 1, y + 1));
      scene.world.triangles.emplace_back(at(x, y), at(x + 1, y + 1), at(x, y + 1));
      scene.world.triangle_part.insert(scene.world.triangle_part.end(), 2, 0);
    }
  }
  scene.world.parts.push_back({});
  const FeatureSet features(scene.world);
  EXPECT_GT(features.counts().silhouette_candidates, 8000u);
  HitLists lists;
  lists.reset(features, unit_frame(), 1.0f / 64.0f);
  HitLists::List list;
  lists.refine({0, 0, 1}, {}, lists.root(), list);
  EXPECT_TRUE(list.empty());
}

TEST(HitLists, EdgesBehindTheApexDoNotCount) {
  PolygonScene scene;
  scene.add({at_depth(0.2, 0.2, -3.0), at_depth(0.8, 0.2, -3.0), at_depth(0.5, 0.8, -3.0)});
  const FeatureSet features(scene.world);
  HitLists lists;
  lists.reset(features, unit_frame(), 0.0f);
  HitLists::List list;
  lists.refine({0, 0, 1}, {}, lists.root(), list);
  EXPECT_TRUE(list.empty());
}

TEST(HitLists, AnEdgeThatPassesBesideTheApexIsCutThere) {
  // An edge from far ahead to far behind, which crosses the square and passes the apex on one side.
  PolygonScene scene;
  scene.add({{0.3f, -0.4f, -10.0f}, {0.3f, -0.4f, 10.0f}, {50.0f, 30.0f, 10.0f}});
  const FeatureSet features(scene.world);
  HitLists lists;
  lists.reset(features, unit_frame(), 0.0f);
  HitLists::List list;
  lists.refine({0, 0, 1}, {}, lists.root(), list);
  // The edge next to the apex, and the start of the one that leads away from it.
  ASSERT_EQ(list.size(), 2u);
  const auto beside = [&](std::uint32_t i) {
    const FeatureEdge& e = features.edges()[lists.segment(i).edge];
    return std::max(e.a, e.b) == 1;
  };
  const Segment& s = lists.segment(beside(list[0]) ? list[0] : list[1]);
  // The line x = 0.3, y = -0.4 goes through the frame's (0, 0) and (0.03, 0.04): v = 4/3 u.
  EXPECT_NEAR(s.v0 * 3.0f, s.u0 * 4.0f, 1e-5f);
  EXPECT_NEAR(s.v1 * 3.0f, s.u1 * 4.0f, 1e-5f);
  EXPECT_NEAR(std::max(s.v0, s.v1), 1.0f + 1.0f / 16.0f, 1e-5f);
  EXPECT_NEAR(std::min(s.u0, s.u1), 0.03f, 1e-6f);
}

}  // namespace
}  // namespace asos::test
