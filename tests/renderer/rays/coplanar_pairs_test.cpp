#include "renderer/rays/coplanar_pairs.h"

#include "renderer/rays/coplanar.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

// The search for coplanar triangles: it marks what all pairs mark, and compares few of them.

namespace asos::coplanar_pairs_test {
namespace {

using test::add_part;
using test::add_quad;
using test::matte;
using test::TinyVertex;

const Material grey = matte(glm::vec3(0.5f));

/// Marks by comparing all pairs.
std::vector<std::uint8_t> marks_of_all_pairs(const World& world) {
  std::vector<std::uint8_t> marks(world.triangles.size(), 0);
  for (std::uint32_t s = 0; s < marks.size(); ++s)
    for (std::uint32_t t = s + 1; t < marks.size(); ++t)
      if (world.triangle_part[s] != world.triangle_part[t] && tracing::coplanar(world, s, t))
        marks[s] = marks[t] = 1;
  return marks;
}

std::vector<std::uint8_t> marks_of(const World& world) {
  tracing::Coplanar found = tracing::find_coplanar(world);
  if (found.by_triangle.empty()) found.by_triangle.resize(world.triangles.size());
  return found.by_triangle;
}

std::ptrdiff_t count(const std::vector<std::uint8_t>& marks) {
  return std::count(marks.begin(), marks.end(), 1);
}

glm::vec3 random_vector(std::mt19937& rng) {
  std::normal_distribution<float> any;
  const float x = any(rng), y = any(rng);
  return {x, y, any(rng)};
}

/// A parallelogram of n by n squares of two triangles, in one part.
void add_sheet(World& world, glm::vec3 corner, glm::vec3 a, glm::vec3 b, std::uint32_t n) {
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  const float side = 1.0f / static_cast<float>(n);
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k)
      vertices.push_back(
          {corner + static_cast<float>(i) * side * a + static_cast<float>(k) * side * b,
           {0, 0, 1},
           {0, 0}});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t at = i * (n + 1) + k;
      triangles.emplace_back(at, at + 1, at + n + 2);
      triangles.emplace_back(at, at + n + 2, at + n + 1);
    }
  add_part(world, vertices, triangles, grey);
}

/// Triangles of all sizes and shapes. Most lie in one of a few planes, with others next to them.
World decals(unsigned seed, glm::dvec3 origin) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  World world{.origin = origin};
  for (int plane = 0; plane < 4; ++plane) {
    const glm::vec3 centre = random_vector(rng), right = glm::normalize(random_vector(rng));
    const glm::vec3 up = plane == 0 ? glm::vec3(0, 1, 0) : glm::normalize(random_vector(rng));
    add_sheet(world, centre, 2.0f * right, 2.0f * up, 6);
    for (int i = 0; i < 30; ++i) {
      const float size = std::pow(10.0f, -5.0f * share(rng));
      const float thin = i % 3 == 0 ? 1e-4f : 1.0f;
      const float off = i % 4 == 0 ? 0.3f * size * share(rng) : 0.0f;
      const glm::vec3 at = centre + 2.0f * (share(rng) * right + share(rng) * up) +
                           off * glm::normalize(glm::cross(right, up));
      const float turn = 6.0f * share(rng);
      const glm::vec3 a = std::cos(turn) * right + std::sin(turn) * up;
      const glm::vec3 b = std::cos(turn) * up - std::sin(turn) * right;
      if (i % 2 == 0)
        add_quad(world, at, size * a, thin * size * b, grey);
      else
        test::add_triangle(world, at, at + size * a, at + thin * size * b, grey);
    }
  }
  return world;
}

TEST(CoplanarPairs, AreThoseOfAllPairs) {
  std::ptrdiff_t marked = 0, all = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    // Far from the origin, rounding errors are as large as some triangles.
    const World world = decals(seed, seed % 3 == 2 ? glm::dvec3(500, 0, -2000) : glm::dvec3(0));
    const std::vector<std::uint8_t> wanted = marks_of_all_pairs(world), found = marks_of(world);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::uint32_t i = 0; i < wanted.size(); ++i)
      EXPECT_EQ(found[i], wanted[i]) << "seed " << seed << ", triangle " << i;
    marked += count(wanted), all += static_cast<std::ptrdiff_t>(wanted.size());
  }
  EXPECT_GT(4 * marked, all);
  EXPECT_LT(4 * marked, 3 * all);
}

TEST(CoplanarPairs, AreFoundInSheetsThatShareAPlane) {
  const auto compared = [](std::uint32_t n) {
    World world;
    const glm::vec3 a(0.8f, 0.1f, 0.2f), b(-0.1f, 0.7f, 0.3f);
    add_sheet(world, {0, 0, 0}, a, b, n);
    add_sheet(world, 0.25f * (a + b), a, b, n + 1);
    const tracing::Coplanar found = tracing::find_coplanar(world);
    EXPECT_EQ(count(found.by_triangle), count(marks_of_all_pairs(world)));
    EXPECT_LE(found.compared, 8 * world.triangles.size());
    return found.compared;
  };
  const std::size_t few = compared(8);
  EXPECT_LT(compared(16), 5 * few);
}

TEST(CoplanarPairs, AreComparedUntilBothAreMarked) {
  World world;
  constexpr std::size_t copies = 2000;
  for (std::size_t i = 0; i < copies; ++i) add_quad(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, grey);
  const tracing::Coplanar found = tracing::find_coplanar(world);
  EXPECT_EQ(count(found.by_triangle), static_cast<std::ptrdiff_t>(2 * copies));
  EXPECT_LE(found.compared, 4 * copies);
}

/// Spokes of a wheel and a rim of small triangles: the boxes of most spokes meet each other, and
/// those of most triangles of the rim.
TEST(CoplanarPairs, AreFewAmongLongThinTriangles) {
  constexpr std::uint32_t spokes = 256, pieces = 4096;
  World world;
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const glm::vec3 p : {a, b, c}) vertices.push_back({p, {0, 0, 1}, {0, 0}});
    triangles.emplace_back(first, first + 1, first + 2);
  };
  const auto on_circle = [](double turn, double radius, double depth) {
    const double angle = 2.0 * std::numbers::pi * turn;
    return glm::vec3(glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), depth));
  };
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double turn = static_cast<double>(i) / spokes;
    add(on_circle(turn, 0.1, 0.05), on_circle(turn + 0.002, 0.1, 0.05), on_circle(turn, 1.1, 0.0));
  }
  add_part(world, vertices, triangles, grey);
  vertices.clear(), triangles.clear();
  for (std::uint32_t i = 0; i < pieces; ++i) {
    const double turn = static_cast<double>(i) / pieces, next = (i + 1.0) / pieces;
    add(on_circle(turn, 1.0, -0.02), on_circle(next, 1.0, -0.02), on_circle(turn, 1.0, 0.02));
    add(on_circle(next, 1.0, 0.02), on_circle(turn, 1.0, 0.02), on_circle(next, 1.0, -0.02));
  }
  add_part(world, vertices, triangles, grey);
  const tracing::Coplanar found = tracing::find_coplanar(world);
  EXPECT_EQ(count(found.by_triangle), 0);
  EXPECT_LE(found.compared, 64 * spokes);
}

/// Rounding errors are as large as the whole cloud, whose triangles are too small to overlap by
/// them.
TEST(CoplanarPairs, AreFewFarFromTheOrigin) {
  std::mt19937 rng(1);
  World world{.origin = {2e6, 0.0, 0.0}};
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 at = random_vector(rng);
    test::add_triangle(world, at, at + 0.1f * random_vector(rng), at + 0.1f * random_vector(rng),
                       grey);
  }
  add_quad(world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, grey);
  const tracing::Coplanar found = tracing::find_coplanar(world);
  EXPECT_EQ(marks_of(world), marks_of_all_pairs(world));
  EXPECT_LE(found.compared, 4 * world.triangles.size());
}

TEST(CoplanarPairs, AreNoneOfTrianglesWithoutArea) {
  World world;
  for (int i = 0; i < 2000; ++i) test::add_triangle(world, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, grey);
  EXPECT_EQ(tracing::find_coplanar(world).compared, 0u);
}

TEST(CoplanarPairs, AreNotSoughtInASinglePart) {
  World world;
  add_sheet(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8);
  add_sheet(world, {0, 0, 0.5f}, {1, 0, 0}, {0, 1, 0}, 8);
  EXPECT_EQ(tracing::find_coplanar(world).compared, 0u);
}

}  // namespace
}  // namespace asos::coplanar_pairs_test
