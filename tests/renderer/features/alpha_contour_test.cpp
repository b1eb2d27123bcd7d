#include "renderer/features/alpha_contour.h"

#include "renderer/shading/texture.h"
#include "tests/support/random_space.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

// The curve where a texture's alpha equals the cutoff, against the alpha that rays look up.

namespace asos::test::alpha_contour_test {
namespace {

constexpr int width = 7, height = 5;
constexpr float factor = 0.9f, cutoff = 0.4f;

struct Case {
  const char* name;
  std::uint8_t (*alpha)(int x, int y);
};

constexpr Case cases[] = {
    {"noise",
     [](int x, int y) { return static_cast<std::uint8_t>((x * 89 + y * 151 + x * y * 37) % 256); }},
    {"checker", [](int x, int y) { return static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0); }},
    {"ramp", [](int x, int /*y*/) { return static_cast<std::uint8_t>(40 * x); }},
    {"dot", [](int x, int y) { return static_cast<std::uint8_t>(x == 3 && y == 2 ? 255 : 0); }},
};

Image image_of(const Case& c) {
  return make_image(width, height, [&](int x, int y) -> Texel { return {9, 8, 7, c.alpha(x, y)}; });
}

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// All pieces of the curve within a rectangle, in texels.
std::vector<ContourPiece> pieces_between(const AlphaContour& contour, glm::dvec2 lo, glm::dvec2 hi,
                                         double tolerance) {
  std::vector<ContourCell> cells;
  const AlphaContour::Rows rows = contour.rows(lo.y, hi.y);
  for (std::int64_t row = rows.first; row < rows.end; ++row)
    contour.find_cells(row, lo.x, hi.x, lo.y, hi.y, cells);
  std::vector<ContourPiece> pieces;
  for (const ContourCell& cell : cells) contour.find_pieces(cell, tolerance, pieces);
  return pieces;
}

class ContourOf : public testing::TestWithParam<Case> {};

// A path between a transparent and an opaque point crosses the curve an odd number of times; one
// between points of the same kind, an even number.
TEST_P(ContourOf, SeparatesOpaqueFromTransparent) {
  constexpr double tolerance = 1e-4;
  for (const Wrap wrap_u : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    for (const Wrap wrap_v : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
      for (const Filter filter : {Filter::linear, Filter::nearest}) {
        World world;
        const int texture = add_texture(world, image_of(GetParam()), wrap_u, filter);
        world.textures.back().wrap_v = wrap_v;
        const AlphaContour contour(world.images[0], world.textures[0], factor, cutoff);
        const glm::dvec2 lo(-19.3, -17.1), hi(23.7, 21.9);
        const auto pieces = pieces_between(contour, lo, hi, tolerance);
        ASSERT_FALSE(pieces.empty());
        const auto alpha = [&](glm::dvec2 p) {
          const glm::vec2 uv((p + 0.5) / glm::dvec2(width, height));
          return factor * sample_texture(world, texture, uv, Encoding::linear).a;
        };
        RandomSpace random(5);
        int differ = 0;
        for (int i = 0; i < 400; ++i) {
          const auto place = [&] {
            return glm::dvec2(random.between(lo.x, hi.x), random.between(lo.y, hi.y));
          };
          // Half of the points start near the image's centre, where the dot is.
          const glm::dvec2 p =
              i % 2 ? place() : glm::dvec2(random.between(2, 4), random.between(1, 3));
          const glm::dvec2 q = place();
          // Very close to the curve rounding decides.
          const auto unsure = [&](glm::dvec2 at) {
            for (const glm::dvec2 off : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
              if ((alpha(at + 1e-3 * off) >= cutoff) != (alpha(at) >= cutoff)) return true;
            return false;
          };
          if (unsure(p) || unsure(q)) continue;
          const auto crossings = std::count_if(pieces.begin(), pieces.end(), [&](const auto& s) {
            const auto left = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
              return cross(b - a, c - a) < 0.0;
            };
            return left(p, q, s.from) != left(p, q, s.to) &&
                   left(s.from, s.to, p) != left(s.from, s.to, q);
          });
          const bool apart = (alpha(p) >= cutoff) != (alpha(q) >= cutoff);
          EXPECT_EQ(crossings % 2 == 1, apart) << i;
          differ += apart;
        }
        EXPECT_GT(differ, 20);
      }
    }
  }
}

// The centres of pieces are within the tolerance of the curve; with half the tolerance there are
// more pieces, so it is the tolerance that decides.
TEST_P(ContourOf, StaysWithinTheTolerance) {
  World world;
  const int texture = add_texture(world, image_of(GetParam()), Wrap::repeat, Filter::linear);
  const AlphaContour contour(world.images[0], world.textures[0], factor, cutoff);
  const auto off = [&](glm::dvec2 p) {
    const auto alpha = [&](glm::dvec2 at) {
      const glm::vec2 uv((at + 0.5) / glm::dvec2(width, height));
      return static_cast<double>(factor * sample_texture(world, texture, uv, Encoding::linear).a) -
             static_cast<double>(cutoff);
    };
    constexpr double h = 1e-3;
    const glm::dvec2 slope(alpha(p + glm::dvec2(h, 0)) - alpha(p - glm::dvec2(h, 0)),
                           alpha(p + glm::dvec2(0, h)) - alpha(p - glm::dvec2(0, h)));
    return std::abs(alpha(p)) / (glm::length(slope) / (2.0 * h));
  };
  for (const double tolerance : {0.05, 0.005, 0.0005}) {
    double worst = 0.0;
    for (const ContourPiece& piece :
         pieces_between(contour, {0.2, 0.2}, {width - 1.2, height - 1.2}, tolerance))
      worst = std::max(worst, off(0.5 * (piece.from + piece.to)));
    EXPECT_LT(worst, 1.05 * tolerance + 2e-5);
    RecordProperty("worst_at_" + std::to_string(tolerance), std::to_string(worst));
  }
}

INSTANTIATE_TEST_SUITE_P(Textures, ContourOf, testing::ValuesIn(cases),
                         [](const auto& tested) { return tested.param.name; });

// A checkerboard at half its alpha: the curve's arcs meet halfway between four texels.
TEST(AlphaContour, SplitsSaddlesIntoTwoLines) {
  Texture sampler;
  const Image image = make_image(2, 2, [](int x, int y) -> Texel {
    return {0, 0, 0, static_cast<std::uint8_t>(x == y ? 254 : 0)};
  });
  const float half = 127.0f / 255.0f;
  const AlphaContour contour(image, sampler, 1.0f, half);
  const auto pieces = pieces_between(contour, {0.1, 0.1}, {0.9, 0.9}, 1e-4);
  for (const ContourPiece& piece : pieces) {
    for (const glm::dvec2 p : {piece.from, piece.to})
      EXPECT_NEAR(std::min(std::abs(p.x - 0.5), std::abs(p.y - 0.5)), 0.0, 1e-4);
  }
  EXPECT_GE(pieces.size(), 4u);
}

TEST(AlphaContour, IsEmptyWhereNothingOrAllIsCutOut) {
  const Image image = image_of(cases[0]);
  const Image even = make_image(3, 3, [](int, int) -> Texel { return {0, 0, 0, 128}; });
  EXPECT_TRUE(AlphaContour(image, {}, 1.0f, 0.0f).empty());
  EXPECT_TRUE(AlphaContour(image, {}, 1.0f, 1.5f).empty());
  EXPECT_TRUE(AlphaContour(image, {}, 0.0f, 0.5f).empty());
  EXPECT_TRUE(AlphaContour(even, {}, 1.0f, 0.5f).empty());
  EXPECT_FALSE(AlphaContour(image, {}, 1.0f, 0.5f).empty());
}

}  // namespace
}  // namespace asos::test::alpha_contour_test
