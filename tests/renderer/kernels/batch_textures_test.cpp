#include "renderer/kernels/batch_textures.h"

#include "renderer/shading/texture_filter.h"
#include "tests/renderer/shading/textured_triangle.h"
#include "tests/support/every_target.h"
#include "tests/support/random_space.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

// Look-ups of batches against those of single places. They have the same bits.

namespace asos::test::batch_textures_test {
namespace {

using Found = std::array<glm::vec4, ShadingPoints::size>;

Image noise(int width, int height) {
  return make_image(width, height, [](int x, int y) {
    const auto byte = [&](int c) {
      return static_cast<std::uint8_t>((x * 37 + y * 101 + x * y * 13 + c * 59) % 256);
    };
    return Texel{byte(0), byte(1), byte(2), byte(3)};
  });
}

/// Points with footprints of 2^-10 to 2^2 of the texture, at any angle and of any shape, and some
/// that are points.
void fill(BatchTextures::Points& points, std::size_t count, RandomSpace& space) {
  points.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    points.triangle[i] = 0;
    points.b1[i] = static_cast<float>(space.between(-3.0, 3.0));
    points.b2[i] = static_cast<float>(space.between(-3.0, 3.0));
    const double size = i % 16 == 0 ? 0.0 : std::exp2(space.between(-10.0, 2.0));
    const double shape = i % 5 == 0 ? 20.0 : 1.0;
    const auto edge = [&](double by) {
      return static_cast<float>(i % 3 == 0 && by < 0.0 ? 0.0 : size * space.between(-1.0, 1.0));
    };
    points.footprint.right_x[i] = static_cast<float>(shape) * edge(1.0);
    points.footprint.right_y[i] = edge(-1.0);
    points.footprint.down_x[i] = edge(-1.0);
    points.footprint.down_y[i] = edge(1.0);
    points.side[i] = static_cast<float>(i % 2 ? 0.125 : space.between(0.1, 2.0));
    points.colours[i] = i % 4 == 0 ? 1.5f : 1.0f;
    points.cutoff[i] = static_cast<float>(space.between(0.2, 0.8));
  }
}

/// Makes every seventh footprint one that has no area, no numbers, no end, or edges that are almost
/// along the texels.
void break_some(BatchTextures::Points& points) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float huge[]{std::numeric_limits<float>::infinity(), 1e30f, 3e38f};
  for (std::size_t i = 0; i < points.count; i += 7) {
    BatchTextures::Points& p = points;
    const std::size_t kind = i / 7 % 8;
    if (kind < 2) p.footprint.down_x[i] = p.footprint.right_x[i];
    if (kind < 2) p.footprint.down_y[i] = p.footprint.right_y[i];
    if (kind == 1) p.footprint.down_y[i] *= 1.0f + 1e-6f;
    if (kind == 2) p.footprint.right_x[i] = nan;
    if (kind >= 3 && kind < 6) p.footprint.right_y[i] = huge[kind - 3];
    if (kind >= 6) {  // turned by a right angle, but for less than a float can divide by
      p.footprint.right_y[i] = 0.02f, p.footprint.down_x[i] = kind == 6 ? 0.02f : -0.05f;
      p.footprint.right_x[i] = p.footprint.down_y[i] = 1e-42f;
    }
    if (i % 2) p.b1[i] = i % 3 ? nan : 1e20f;
  }
}

glm::vec4 expected(const Textured& t, TexelKind kind, const BatchTextures::Points& p,
                   std::size_t i) {
  Footprint footprint;
  footprint.right = {p.footprint.right_x[i], p.footprint.right_y[i]};
  footprint.down = {p.footprint.down_x[i], p.footprint.down_y[i]};
  footprint.side = p.side[i];
  footprint.colours = p.colours[i];
  if (kind == TexelKind::color) footprint = of_colours(footprint);
  const TexturePlace place{0, p.b1[i], p.b2[i], footprint};
  if (kind == TexelKind::normal) {
    const MeanNormal mean = filtered_normal(t.world, t.mips, t.use, place);
    return {mean.texel, mean.variance};
  }
  const auto cutoff = p.masked ? std::optional(p.cutoff[i]) : std::nullopt;
  return filtered_texture(t.world, t.mips, t.use, {kind, cutoff}, place);
}

bool equal(glm::vec4 a, glm::vec4 b) {
  for (int c = 0; c < 4; ++c)
    if (a[c] != b[c] && !(std::isnan(a[c]) && std::isnan(b[c]))) return false;
  return true;
}

void compare(const Textured& t, TexelKind kind, bool masked, std::uint64_t seed,
             bool broken = false) {
  const auto textures = std::make_unique<BatchTextures>();
  const auto found = std::make_unique<Found>();
  RandomSpace space(seed);
  for (const std::size_t count : {std::size_t{253}, std::size_t{1}}) {
    BatchTextures::Points& points = textures->points();
    fill(points, count, space);
    if (broken) break_some(points);
    points.masked = masked;
    textures->start(t.world, &t.mips);
    textures->look_up(t.use, kind, *found);
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_TRUE(equal((*found)[i], expected(t, kind, points, i))) << "point " << i;
  }
}

TEST(BatchTextures, AreTheOnesLookedUpOneByOne) {
  for_every_target([] {
    std::uint64_t seed = 1;
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
      for (const Filter filter : {Filter::linear, Filter::nearest}) {
        for (const auto& [width, height] :
             {std::pair(64, 64), std::pair(1, 37), std::pair(90, 20)}) {
          SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
          Textured opaque(noise(width, height), wrap, filter);
          opaque.use.uv_transform = {2.0f, 0.5f, 0.0f, -0.25f, 1.0f, 0.0f, 0.1f, 0.2f, 1.0f};
          for (const TexelKind kind : {TexelKind::color, TexelKind::data, TexelKind::normal})
            compare(opaque, kind, false, ++seed);
          const Textured covers(noise(width, height), wrap, filter, AlphaMode::blend);
          for (const bool masked : {false, true}) compare(covers, TexelKind::cover, masked, ++seed);
        }
      }
    }
  });
}

// Once rows beyond a patch asked for more memory than there is.
TEST(BatchTextures, OfFootprintsWithoutNumbersAreThoseOfOne) {
  for_every_target([] {
    for (const Filter filter : {Filter::linear, Filter::nearest}) {
      const Textured t(noise(64, 64), Wrap::repeat, filter);
      for (const TexelKind kind : {TexelKind::color, TexelKind::normal})
        for (std::uint64_t seed = 1; seed < 20; ++seed) compare(t, kind, false, seed, true);
    }
  });
}

TEST(BatchTextures, AMissingImageIsWhite) {
  Textured t(noise(8, 8));
  t.use.texture = 100;
  const auto textures = std::make_unique<BatchTextures>();
  const auto found = std::make_unique<Found>();
  RandomSpace space(5);
  fill(textures->points(), 3, space);
  textures->start(t.world, &t.mips);
  textures->look_up(t.use, TexelKind::data, *found);
  EXPECT_EQ((*found)[2], glm::vec4(1.0f));
}

}  // namespace
}  // namespace asos::test::batch_textures_test
