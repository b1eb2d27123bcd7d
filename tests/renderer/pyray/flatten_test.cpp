#include "renderer/pyray/flatten.h"

#include "renderer/features/feature_set.h"
#include "renderer/pyray/hit_list.h"
#include "tests/support/random_space.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace asos {
namespace {

constexpr double pi = std::numbers::pi;

/// Orthographic, so that lengths are those of the world: the square is 0 to 1 in x and y.
Frame unit_square() {
  return Frame::prism({0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0});
}

EllipseArc circle(glm::dvec2 centre, double radius) {
  return {{centre, 0.0}, {radius, 0, 0}, {0, radius, 0}};
}

double area(std::span<const Segment> segments) {
  double twice = 0.0;
  for (const Segment& s : segments)
    twice += static_cast<double>(s.u0) * s.v1 - static_cast<double>(s.u1) * s.v0;
  return 0.5 * std::abs(twice);
}

TEST(Flatten, AClosedArcKeepsItsArea) {
  Flattener flattener;
  for (const double radius : {0.4, 0.1, 0.01}) {
    for (const double finest : {1.0 / 8.0, 1.0 / 64.0}) {
      const auto pieces =
          flattener.flatten(unit_square(), circle({0.5, 0.5}, radius), {}, finest, {});
      ASSERT_GE(pieces.size(), 6u);
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Segment& next = pieces[(i + 1) % pieces.size()];
        EXPECT_EQ(pieces[i].u1, next.u0);
        EXPECT_EQ(pieces[i].v1, next.v0);
      }
      // Chords alone would lose about 4 radius^2 (pi / n)^2 / 6.
      const double n = static_cast<double>(pieces.size());
      EXPECT_NEAR(area(pieces), pi * radius * radius,
                  pi * radius * radius * 8.0 / (n * n * n * n) * 10.0 + 1e-7);
    }
  }
}

TEST(Flatten, NoPointIsFarFromTheArc) {
  Flattener flattener;
  test::RandomSpace space(2);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 centre(space.between(-1, 2), space.between(-1, 2));
    const double radius = std::exp(space.between(-4.0, 2.0));
    const double finest = 1.0 / 32.0;
    FlattenBounds bounds{.margin = 1.0 / 16.0};
    for (const Segment& s :
         flattener.flatten(unit_square(), circle(centre, radius), {}, finest, bounds)) {
      for (const float t : {0.0f, 0.5f, 1.0f}) {
        const glm::dvec2 p(s.u0 + t * (s.u1 - s.u0), s.v0 + t * (s.v1 - s.v0));
        EXPECT_LT(std::abs(glm::distance(p, centre) - radius), finest / 16.0);
        EXPECT_GT(std::min(p.x, p.y), -bounds.margin - finest / 16.0);
        EXPECT_LT(std::max(p.x, p.y), 1.0 + bounds.margin + finest / 16.0);
      }
    }
  }
}

TEST(Flatten, WhatLiesOutsideIsLeftOut) {
  Flattener flattener;
  EXPECT_TRUE(flattener.flatten(unit_square(), circle({3, 3}, 1.0), {}, 0.1, {}).empty());
  // A circle around the square.
  EXPECT_TRUE(flattener.flatten(unit_square(), circle({0.5, 0.5}, 3.0), {}, 0.1, {}).empty());
  const HalfSpace left{{-1, 0, 0}, -0.5};
  FlattenBounds bounds{.within = std::span(&left, 1)};
  for (const Segment& s :
       flattener.flatten(unit_square(), circle({0.5, 0.5}, 0.3), {}, 0.1, bounds))
    EXPECT_LE(std::max(s.u0, s.u1), 0.51f);
}

// The lines of a cylinder's outline end at joints of its rims, bit for bit.
TEST(Flatten, AnOutlineEndsOnRims) {
  World world;
  test::add_shape(world, test::cylinder(1.0, 0.4, 0.3), glm::dmat4(1.0),
                  test::matte(glm::vec3(0.5f)));
  const FeatureSet features(world);
  test::RandomSpace space(9);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 eye = space.between(3.0, 8.0) * space.direction();
    const glm::dvec3 right = 2.0 * space.perpendicular(eye);
    const glm::dvec3 down = 2.0 * glm::normalize(glm::cross(eye, right));
    HitLists lists;
    lists.reset(features, Frame::pyramid(eye, -eye - 0.5 * (right + down), right, down),
                1.0f / 64.0f);
    HitLists::List list;
    lists.refine({}, {}, lists.root(), list);
    std::map<std::pair<float, float>, int> ends;
    int lines = 0;
    for (const std::uint32_t e : list) {
      ASSERT_TRUE(lists.entry(e).is_segment());
      const Segment& s = lists.segment(e);
      lines += lists.kind(e) == FeatureKind::silhouette;
      ++ends[{s.u0, s.v0}];
      ++ends[{s.u1, s.v1}];
    }
    // Seen along the axis there may be no lines.
    ASSERT_TRUE(lines == 2 || lines == 0);
    int joints_of_three = 0;
    for (const auto& [place, count] : ends) {
      EXPECT_GE(count, 2) << i;
      joints_of_three += count == 3;
    }
    EXPECT_EQ(joints_of_three, 2 * lines) << i;
  }
}

}  // namespace
}  // namespace asos
