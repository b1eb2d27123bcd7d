#include "renderer/features/cut_outs.h"

#include "renderer/features/feature_set.h"
#include "renderer/shading/shade.h"
#include "tests/support/random_space.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

// Outlines of cut-outs on triangles, against the opacity that rays look up.

namespace asos::test::cut_outs_test {
namespace {

Material leaves(World& world, Wrap wrap, Filter filter) {
  Material material = matte({1, 1, 1});
  material.alpha_mode = AlphaMode::mask;
  material.alpha_cutoff = 0.35f;
  material.base_color_texture.texture = add_texture(
      world,
      make_image(
          11, 6,
          [](int x, int y) -> Texel {
            return {1, 2, 3, static_cast<std::uint8_t>((x * x * 31 + y * 57 + x * y * 13) % 256)};
          }),
      wrap, filter);
  return material;
}

/// A fan of triangles around a point of the plane z = 0, within the unit square. The image repeats
/// 1.7 times and 2.3 times.
World fan(Wrap wrap, Filter filter) {
  World world;
  Material material = leaves(world, wrap, filter);
  material.base_color_texture.uv_transform =
      glm::mat3(glm::vec3(1.6f, 0.4f, 0), glm::vec3(-0.5f, 2.2f, 0), glm::vec3(0.13f, -0.71f, 1));
  const auto corner = [](float x, float y) {
    return TinyVertex{{x, y, 0.25f * x}, {0, 0, 1}, {x, y}};
  };
  add_part(world, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), corner(0.31f, 0.43f)},
           {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, material);
  return world;
}

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// Whether a ray hits the fan at a point of the unit square.
bool solid(const World& world, glm::dvec2 p) {
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    const glm::uvec3 v = world.triangles[t];
    const glm::dvec2 a(world.positions[v.x]);
    const glm::dvec2 e1 = glm::dvec2(world.positions[v.y]) - a;
    const glm::dvec2 e2 = glm::dvec2(world.positions[v.z]) - a;
    const double b1 = cross(p - a, e2) / cross(e1, e2), b2 = cross(e1, p - a) / cross(e1, e2);
    if (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0)
      return opacity_at(world, t, static_cast<float>(b1), static_cast<float>(b2)) > 0.5f;
  }
  return false;
}

TEST(CutOuts, LinesSeparateHolesFromOpaqueParts) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    for (const Filter filter : {Filter::linear, Filter::nearest}) {
      const World world = fan(wrap, filter);
      const CutOuts found = find_cut_outs(world);
      ASSERT_GT(found.lines.size(), 20u);
      EXPECT_EQ(found.outlined, std::vector<std::uint8_t>(4, 1));
      RandomSpace random(3);
      int apart_count = 0;
      for (int i = 0; i < 1000; ++i) {
        const auto place = [&] { return glm::dvec2(random.between(0, 1), random.between(0, 1)); };
        const glm::dvec2 p = place(), q = place();
        const auto unsure = [&](glm::dvec2 at) {
          for (const glm::dvec2 off : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
            if (solid(world, at + 1e-4 * off) != solid(world, at)) return true;
          return false;
        };
        if (unsure(p) || unsure(q)) continue;
        const auto crossings =
            std::count_if(found.lines.begin(), found.lines.end(), [&](const CutOutLine& line) {
              const glm::dvec2 a(found.positions[line.a]), b(found.positions[line.b]);
              return (cross(q - p, a - p) < 0.0) != (cross(q - p, b - p) < 0.0) &&
                     (cross(b - a, p - a) < 0.0) != (cross(b - a, q - a) < 0.0);
            });
        const bool apart = solid(world, p) != solid(world, q);
        EXPECT_EQ(crossings % 2 == 1, apart) << i;
        apart_count += apart;
      }
      EXPECT_GT(apart_count, 100);
    }
  }
}

/// A curved sheet of n x n quadrilaterals of various shapes over the unit square.
World sheet(int n) {
  World world;
  const Material material = leaves(world, Wrap::repeat, Filter::linear);
  RandomSpace random(8);
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  const auto across = static_cast<std::uint32_t>(n + 1);
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const auto moved = [&](int i) {
        const double off = i == 0 || i == n ? 0.0 : random.between(-0.3, 0.3);
        return static_cast<float>((i + off) / n);
      };
      const glm::vec2 at(moved(x), moved(y));
      const glm::vec3 position(at, 0.2f * std::sin(3.0f * at.x + at.y));
      vertices.push_back({position, {0, 0, 1}, 1.5f * at + glm::vec2(at.y * at.y, 0.3f * at.x)});
    }
  }
  for (std::uint32_t i = 0; i + across < vertices.size(); ++i) {
    if (i % across == across - 1) continue;
    triangles.emplace_back(i, i + 1, i + across);
    triangles.emplace_back(i + 1, i + across + 1, i + across);
  }
  add_part(world, vertices, triangles, material);
  return world;
}

// Outlines continue across triangles: each end within the surface coincides with the end of another
// line, bit by bit. At the surface's border they end.
TEST(CutOuts, LinesJoinToTheBit) {
  for (const World& world : {fan(Wrap::repeat, Filter::linear), sheet(40)}) {
    const CutOuts found = find_cut_outs(world);
    std::map<std::tuple<float, float, float>, int> ends;
    for (const CutOutLine& line : found.lines) {
      for (const std::uint32_t i : {line.a, line.b}) {
        const glm::vec3 p = found.positions[i];
        ++ends[{p.x, p.y, p.z}];
      }
    }
    int on_rim = 0;
    for (const auto& [place, count] : ends) {
      const auto [x, y, z] = place;
      const bool rim = std::min({x, y, 1.0f - x, 1.0f - y}) < 1e-6f;
      on_rim += rim;
      EXPECT_EQ(count, rim ? 1 : 2) << x << ' ' << y;
    }
    EXPECT_GT(on_rim, 4);
  }
}

TEST(CutOuts, StandOnTheTriangles) {
  const World world = fan(Wrap::repeat, Filter::linear);
  const CutOuts found = find_cut_outs(world);
  for (const glm::vec3& p : found.positions) EXPECT_NEAR(p.z, 0.25f * p.x, 1e-6f);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().cut_out, found.lines.size());
  EXPECT_FALSE(features.cut_outs_unbounded());
  EXPECT_FALSE(features.opacity_unbounded());
}

// Cut-outs without an outline are marked as such and get no lines.
TEST(CutOuts, MarkCutOutsWithoutOutlineForSampling) {
  const auto left_out = [](World world, const CutOutBudget& budget = {}) {
    const CutOuts found = find_cut_outs(world, budget);
    EXPECT_TRUE(found.lines.empty());
    return found.outlined == std::vector<std::uint8_t>(world.surface_count(), 0);
  };
  EXPECT_TRUE(left_out(fan(Wrap::repeat, Filter::linear), {.lines = 15}));
  EXPECT_TRUE(left_out(fan(Wrap::repeat, Filter::linear), {.looks = 30}));
  // Alpha that differs between the corners of a triangle.
  World coloured = fan(Wrap::repeat, Filter::linear);
  coloured.colors.assign(coloured.positions.size(), glm::vec4(1.0f));
  EXPECT_FALSE(find_cut_outs(coloured).lines.empty());
  coloured.colors[4].a = 0.5f;
  EXPECT_TRUE(left_out(coloured));
  // Invalid texture coordinates.
  for (const float wild :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e30f}) {
    World world = fan(Wrap::repeat, Filter::linear);
    world.texcoords[0][4] = {wild, 0.0f};
    EXPECT_TRUE(left_out(world)) << wild;
    EXPECT_TRUE(FeatureSet(world).cut_outs_unbounded());
  }
  // More repetitions than the limit.
  World endless = fan(Wrap::repeat, Filter::linear);
  endless.materials[0].base_color_texture.uv_transform *= 1e6f;
  EXPECT_TRUE(left_out(endless));
  // A texture degenerated to a line across the surface.
  World line = fan(Wrap::repeat, Filter::linear);
  for (glm::vec2& uv : line.texcoords[0]) uv.y = 0.0f;
  EXPECT_TRUE(left_out(line));
  // Without masks there is nothing to outline.
  World plain = fan(Wrap::repeat, Filter::linear);
  plain.materials[0].alpha_mode = AlphaMode::blend;
  EXPECT_TRUE(find_cut_outs(plain).outlined.empty());
  EXPECT_TRUE(FeatureSet(plain).opacity_unbounded());
}

// A thousand leaves, each with several repetitions of the image.
void add_thicket(World& world, const Material& material) {
  constexpr float times = 4.0f;
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    vertices.push_back({{x, 0, 0}, {0, 0, 1}, {0, 0}});
    vertices.push_back({{x + 1, 0, 0}, {0, 0, 1}, {times, 0}});
    vertices.push_back({{x, 1, 0}, {0, 0, 1}, {0, times}});
    triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  add_part(world, vertices, triangles, material);
}

// Parts with too many lines use up little of the other parts' budget.
TEST(CutOuts, ComplexCutOutsLeaveBudgetForOthers) {
  World world = fan(Wrap::repeat, Filter::linear);
  const Material material = world.materials[0];
  world = World{};
  (void)leaves(world, Wrap::repeat, Filter::linear);
  for (int i = 0; i < 16; ++i) add_thicket(world, material);
  const auto first = static_cast<std::uint32_t>(world.triangles.size());
  World last = fan(Wrap::repeat, Filter::linear);
  std::vector<TinyVertex> vertices;
  for (std::size_t i = 0; i < last.positions.size(); ++i)
    vertices.push_back({last.positions[i], last.normals[i], last.texcoords[0][i]});
  add_part(world, vertices, {last.triangles.begin(), last.triangles.end()}, material);
  const CutOuts found = find_cut_outs(world, {100'000, std::size_t{1} << 17});
  ASSERT_EQ(found.outlined.size(), first + 4);
  EXPECT_EQ(std::count(found.outlined.begin(), found.outlined.begin() + first, 1), 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found.outlined[first + i], 1) << i;
  EXPECT_GT(found.lines.size(), 100u);
}

TEST(CutOuts, FindTransparentSides) {
  World world;
  Material material = matte({1, 1, 1});
  material.alpha_mode = AlphaMode::mask;
  // Transparent except for a spot that reaches the right side.
  material.base_color_texture.texture = add_texture(
      world,
      make_image(8, 8,
                 [](int x, int y) -> Texel {
                   return {1, 2, 3, static_cast<std::uint8_t>(x > 4 && y > 2 && y < 6 ? 255 : 0)};
                 }),
      Wrap::clamp_to_edge, Filter::linear);
  add_quad(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, material);
  const auto sides = find_cut_outs(world).hidden_sides;
  for (std::uint32_t t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) {
      const glm::uvec3 v = world.triangles[t];
      const glm::vec2 p(world.positions[v[k]]), q(world.positions[v[(k + 1) % 3]]);
      bool met = false;
      for (int i = 0; i <= 100; ++i)
        met |= solid(world, glm::mix(p, q, 0.01f * static_cast<float>(i)));
      EXPECT_EQ((sides[t] >> k & 1) != 0, !met) << t << ' ' << k;
    }
  }
  EXPECT_EQ(FeatureSet(world).counts().open, 1u) << "the right side alone";
  // All sides of an opaque card behind it are kept.
  add_quad(world, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, matte({1, 1, 1}));
  EXPECT_EQ(FeatureSet(world).counts().open, 5u);
  // The edge shared with an opaque card is kept, too.
  add_quad(world, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte({1, 1, 1}));
  EXPECT_EQ(FeatureSet(world).counts().open + FeatureSet(world).counts().seam, 9u);
}

// Sides through the outer halves of a texture's first and last texels.
TEST(CutOuts, VisibleSidesAreNeverDropped) {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    World world;
    Material material = matte({1, 1, 1});
    material.alpha_mode = AlphaMode::mask;
    material.base_color_texture.texture =
        add_texture(world,
                    make_image(8, 8,
                               [](int x, int y) -> Texel {
                                 return {1, 2, 3, static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0)};
                               }),
                    wrap, Filter::nearest);
    add_quad(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, material);
    EXPECT_EQ(FeatureSet(world).counts().open, 4u);
  }
}

// With a cutoff of 0, or without a texture, nothing is cut out.
TEST(CutOuts, NeedNoLinesWhereNothingIsCutOut) {
  World world = fan(Wrap::repeat, Filter::linear);
  world.materials[0].alpha_cutoff = 0.0f;
  EXPECT_EQ(find_cut_outs(world).outlined, std::vector<std::uint8_t>(4, 1));
  world.materials[0].alpha_cutoff = 0.5f;
  world.materials[0].base_color_texture.texture = -1;
  EXPECT_EQ(find_cut_outs(world).outlined, std::vector<std::uint8_t>(4, 1));
  EXPECT_TRUE(find_cut_outs(world).lines.empty());
}

}  // namespace
}  // namespace asos::test::cut_outs_test
