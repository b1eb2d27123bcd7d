#include "renderer/pyray/chains.h"

#include "tests/support/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace asos::test {
namespace {

using Segments = std::vector<Segment>;
using Place = std::pair<float, float>;

Place first_of(const Segment& s) {
  return {s.u0, s.v0};
}
Place second_of(const Segment& s) {
  return {s.u1, s.v1};
}

Segments chain_of(const std::vector<glm::vec3>& joints) {
  Segments chain;
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    const glm::vec3 a = joints[i], b = joints[i + 1];
    chain.push_back({a.x, a.y, a.z, b.x, b.y, b.z, static_cast<std::uint32_t>(i)});
  }
  return chain;
}

/// A wavy line of n pieces across the square.
std::vector<glm::vec3> wave(int n, std::mt19937& random) {
  std::uniform_real_distribution<float> noise(-0.002f, 0.002f);
  std::vector<glm::vec3> joints;
  for (int i = 0; i <= n; ++i) {
    const float u = static_cast<float>(i) / static_cast<float>(n);
    joints.emplace_back(u, 0.5f + 0.3f * std::sin(7.0f * u) + noise(random), 1.0f + noise(random));
  }
  return joints;
}

std::vector<glm::vec3> circle(int n, double radius) {
  std::vector<glm::vec3> joints;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    joints.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 1.0);
  }
  joints.push_back(joints.front());
  return joints;
}

/// The pieces in random order and direction.
Segments shuffled(Segments segments, std::mt19937& random) {
  std::shuffle(segments.begin(), segments.end(), random);
  for (Segment& s : segments) {
    if (random() % 2) continue;
    std::swap(s.u0, s.u1), std::swap(s.v0, s.v1), std::swap(s.nearness0, s.nearness1);
  }
  return segments;
}

Segments simplify(const Segments& segments, float tolerance) {
  ChainSimplifier simplifier;
  const auto result = simplifier.simplify(segments, tolerance);
  return {result.begin(), result.end()};
}

double distance(glm::dvec2 p, const Segment& s) {
  const glm::dvec2 a(s.u0, s.v0), d = glm::dvec2(s.u1, s.v1) - a;
  const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
  return glm::distance(p, a + t * d);
}

/// Largest distance of points of `from` from `to`.
double farthest(const Segments& from, const Segments& to) {
  double most = 0.0;
  for (const Segment& s : from) {
    for (int i = 0; i <= 8; ++i) {
      const glm::dvec2 a(s.u0, s.v0), b(s.u1, s.v1);
      const glm::dvec2 p = a + (b - a) * (i / 8.0);
      double nearest = 1.0;
      for (const Segment& t : to) nearest = std::min(nearest, distance(p, t));
      most = std::max(most, nearest);
    }
  }
  return most;
}

/// Every end point of segments, with the number of segments that end there.
std::map<Place, int> ends_of(const Segments& segments) {
  std::map<Place, int> ends;
  for (const Segment& s : segments) ++ends[first_of(s)], ++ends[second_of(s)];
  return ends;
}

/// The segments without their direction.
std::set<std::pair<Place, Place>> undirected(const Segments& segments) {
  std::set<std::pair<Place, Place>> set;
  for (const Segment& s : segments) set.insert(std::minmax(first_of(s), second_of(s)));
  return set;
}

constexpr float rounding = 1e-6f;

TEST(ChainSimplifier, StaysWithinToleranceBothWays) {
  std::mt19937 random(1);
  for (const float tolerance : {0.0005f, 0.003f, 0.02f, 0.5f}) {
    const Segments original = shuffled(chain_of(wave(200, random)), random);
    const Segments result = simplify(original, tolerance);
    EXPECT_LT(result.size(), original.size());
    EXPECT_LE(farthest(original, result), tolerance + rounding);
    EXPECT_LE(farthest(result, original), tolerance + rounding);
  }
}

TEST(ChainSimplifier, KeepsStrongBends) {
  const Segments corner = chain_of({{0, 0, 1}, {0.5f, 0.5f, 1}, {1, 0, 1}});
  EXPECT_EQ(simplify(corner, 0.49f).size(), 2u);
  EXPECT_EQ(simplify(corner, 0.51f).size(), 1u);
  EXPECT_EQ(simplify(corner, 0.0f).size(), 2u);
}

TEST(ChainSimplifier, ChainsBeginAndEndWhereTheyDid) {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const auto joints = wave(64, random);
    const auto ends = ends_of(simplify(shuffled(chain_of(joints), random), 1.0f));
    ASSERT_EQ(ends.size(), 2u);
    EXPECT_TRUE(ends.contains({joints.front().x, joints.front().y}));
    EXPECT_TRUE(ends.contains({joints.back().x, joints.back().y}));
  }
}

TEST(ChainSimplifier, SegmentsThatDoNotMeetStay) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  Segments loose;
  for (int i = 0; i < 100; ++i)
    loose.push_back({unit(random), unit(random), 1, unit(random), unit(random), 1, 0});
  EXPECT_EQ(undirected(simplify(loose, 0.1f)), undirected(loose));
  EXPECT_TRUE(simplify({}, 0.1f).empty());
}

TEST(ChainSimplifier, EndsChainsAtJunctions) {
  std::mt19937 random(4);
  const glm::vec3 junction(0.4f, 0.6f, 1.0f);
  Segments arms;
  for (const glm::vec2 tip : {glm::vec2(0, 0), glm::vec2(1, 0.1f), glm::vec2(0.5f, 1)}) {
    std::vector<glm::vec3> joints;
    for (int i = 0; i <= 20; ++i)
      joints.push_back(glm::mix(junction, glm::vec3(tip, 1.0f), static_cast<float>(i) / 20.0f));
    for (const Segment& s : chain_of(joints)) arms.push_back(s);
  }
  const Segments result = simplify(shuffled(arms, random), 0.01f);
  EXPECT_EQ(result.size(), 3u);
  EXPECT_EQ(ends_of(result).at({junction.x, junction.y}), 3);
}

TEST(ChainSimplifier, AClosedChainStaysClosed) {
  std::mt19937 random(5);
  for (const float tolerance : {0.001f, 0.01f, 0.1f}) {
    const Segments original = shuffled(chain_of(circle(300, 0.4)), random);
    const Segments result = simplify(original, tolerance);
    EXPECT_LT(result.size(), original.size());
    for (const auto& [place, count] : ends_of(result)) EXPECT_EQ(count, 2);
    EXPECT_LE(farthest(original, result), tolerance + rounding);
    EXPECT_LE(farthest(result, original), tolerance + rounding);
  }
}

// A loop attached to a junction begins and ends there.
TEST(ChainSimplifier, ALoopOnAStalkKeepsItsJunction) {
  std::mt19937 random(6);
  const auto loop = circle(100, 0.3);
  Segments segments = chain_of(loop);
  segments.push_back({loop[0].x, loop[0].y, 1, 1, 1, 1, 0});
  const Segments result = simplify(shuffled(segments, random), 0.01f);
  EXPECT_EQ(ends_of(result).at({loop[0].x, loop[0].y}), 3);
  EXPECT_LE(farthest(segments, result), 0.01 + rounding);
}

// The same open chains give the same segments for any order and direction; only the order of the
// result follows the input.
TEST(ChainSimplifier, OpenChainsDependOnTheSetOfSegmentsOnly) {
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    const Segments original = chain_of(wave(200, random));
    const auto expected = undirected(simplify(original, 0.003f));
    EXPECT_EQ(undirected(simplify(shuffled(original, random), 0.003f)), expected);
  }
}

TEST(ChainSimplifier, TheSameInputGivesTheSameBitsFromUsedMemory) {
  std::mt19937 random(8);
  const Segments first = shuffled(chain_of(circle(500, 0.4)), random);
  const Segments second = shuffled(chain_of(wave(100, random)), random);
  ChainSimplifier used;
  (void)used.simplify(second, 0.01f);
  const auto again = used.simplify(first, 0.01f);
  const Segments fresh = simplify(first, 0.01f);
  ASSERT_EQ(again.size(), fresh.size());
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    EXPECT_EQ(first_of(again[i]), first_of(fresh[i]));
    EXPECT_EQ(second_of(again[i]), second_of(fresh[i]));
    EXPECT_EQ(again[i].nearness0, fresh[i].nearness0);
    EXPECT_EQ(again[i].nearness1, fresh[i].nearness1);
  }
}

// A hidden piece must be hidden completely: a piece is as near as the nearest of the segments that
// it replaces.
TEST(ChainSimplifier, IsNeverFartherThanTheChain) {
  std::mt19937 random(9);
  const auto joints = wave(200, random);
  for (const Segment& s : simplify(chain_of(joints), 0.01f)) {
    for (const glm::vec3& j : joints) {
      if (j.x < std::min(s.u0, s.u1) || j.x > std::max(s.u0, s.u1)) continue;
      const float t = (j.x - s.u0) / (s.u1 - s.u0);
      EXPECT_GE(s.nearness0 + t * (s.nearness1 - s.nearness0), j.z - rounding);
    }
  }
}

// A chord of an arc of height h cuts off two thirds of h times its length.
TEST(ChainSimplifier, ACircleOfTenThousandPiecesKeepsItsArea) {
  std::mt19937 random(10);
  const double radius = 0.4;
  const Segments original = shuffled(chain_of(circle(10000, radius)), random);
  for (const float tolerance : {1e-2f, 1e-3f, 1e-4f}) {
    const Segments result = simplify(original, tolerance);
    // Walk around the closed chain, piece by piece.
    std::map<Place, std::vector<Place>> next;
    for (const Segment& s : result) {
      next[first_of(s)].push_back(second_of(s));
      next[second_of(s)].push_back(first_of(s));
    }
    Polygon outline;
    Place before = next.begin()->first, at = before;
    do {
      outline.emplace_back(at.first, at.second);
      const auto& both = next.at(at);
      const Place to = both.at(0) == before ? both.at(1) : both.at(0);
      before = at, at = to;
    } while (at != next.begin()->first && outline.size() <= result.size());
    ASSERT_EQ(outline.size(), result.size());
    const double most =
        2.0 / 3.0 * static_cast<double>(tolerance) * 2.0 * std::numbers::pi * radius;
    EXPECT_NEAR(area(outline), std::numbers::pi * radius * radius, most + 1e-5);
    // Arcs of height h span 2 sqrt(2 h / r); halving stops at most one step late.
    EXPECT_LE(
        static_cast<double>(result.size()),
        2.0 * std::numbers::pi / std::sqrt(2.0 * static_cast<double>(tolerance) / radius) + 2);
  }
}

}  // namespace
}  // namespace asos::test
