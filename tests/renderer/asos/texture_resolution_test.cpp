#include "renderer/asos/pixel_trace.h"
#include "renderer/asos/texture_samples.h"
#include "tests/support/expect_same.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace asos::test::texture_resolution_test {
namespace {

constexpr int picture_side = 24;

/// A plane that fills the picture with black and white squares of 0.31 pixels; optionally with a
/// plain post in front of its centre.
World checks(bool post) {
  World world;
  Material m = unlit(glm::vec3(1));
  m.base_color_texture.texture = add_texture(world,
                                             make_image(2, 2,
                                                        [](int x, int y) {
                                                          const std::uint8_t c =
                                                              (x + y) % 2 == 0 ? 255 : 0;
                                                          return Texel{c, c, c, 255};
                                                        }),
                                             Wrap::repeat, Filter::nearest);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  // Four units are 48 pixels of 1 / 12.
  for (glm::vec2& uv : world.texcoords[0]) uv = uv * (48.0f / 0.62f) + glm::vec2(0.123f, 0.237f);
  if (post) add_quad(world, {-0.33f, -3, 1}, {0.5f, 0.1f, 0}, {0, 6, 0}, unlit({0.2f, 0.4f, 0.6f}));
  return world;
}

/// Includes mip chains for area averages.
std::shared_ptr<const RenderScene> filtered_scene(World world) {
  auto geometry = build_geometry(std::move(world), {}, {}, nullptr).value();
  Lighting lighting = prepare_lighting(geometry->world, {});
  return unedited_scene(std::move(geometry), std::move(lighting));
}

RenderSettings with_tr(int tr) {
  RenderSettings settings = make_settings(picture_side, picture_side);
  settings.texture.filter = TextureFilter::point;
  settings.texture.resolution = tr;
  return settings;
}

/// RMS of the pixels' deviation from the plane's grey, and their mean.
struct PictureSpread {
  double error = 0.0;
  double mean = 0.0;
};

PictureSpread spread_of(const Film& film) {
  PictureSpread s;
  for (const glm::vec3& c : film.radiance) {
    s.mean += static_cast<double>(c.r);
    s.error += std::pow(static_cast<double>(c.r) - 0.5, 2.0);
  }
  const auto pixels = static_cast<double>(film.radiance.size());
  return {std::sqrt(s.error / pixels), s.mean / pixels};
}

TEST(TextureResolution, PointSamplesOfAFineTextureConvergeToItsMean) {
  const auto scene = make_render_scene(checks(false));
  for (const int tr : {1, 2, 4, 8}) {
    const Picture picture = render_picture(*scene, orthographic(2.0), with_tr(tr));
    const PictureSpread s = spread_of(picture.film);
    EXPECT_EQ(picture.statistics.rejected_samples, 0u);
    EXPECT_EQ(picture.statistics.eye_rays,
              static_cast<std::uint64_t>(picture_side * picture_side * (tr > 1 ? tr * tr + 1 : 1)));
    if (tr == 1) continue;
    // Stratified samples of 0 and 1 are at least as good as independent ones, whose mean has a
    // standard deviation of 0.5 / sqrt(n). Allows five of those for the picture's mean.
    EXPECT_LT(s.error, 0.5 / tr) << tr;
    EXPECT_NEAR(s.mean, 0.5, 5.0 * 0.5 / tr / picture_side) << tr;
  }
}

TEST(TextureResolution, ChangesNothingWithoutTextures) {
  const auto scene = make_render_scene(still_life());
  const Camera camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  for (const Method method : {Method::asos, Method::asos_published}) {
    RenderSettings settings = with_tr(1);
    settings.method = method;
    const Picture one = render_picture(*scene, camera, settings);
    settings.texture.resolution = 8;
    const Picture eight = render_picture(*scene, camera, settings);
    EXPECT_EQ(one.film.radiance, eight.film.radiance);
    EXPECT_EQ(one.statistics.eye_rays, eight.statistics.eye_rays);
    EXPECT_EQ(one.statistics.pyrays_by_level, eight.statistics.pyrays_by_level);
  }
}

TEST(TextureResolution, LeavesTheSubdivisionAndItsStatisticsAlone) {
  const auto scene = make_render_scene(checks(true));
  const Picture one = render_picture(*scene, orthographic(2.0), with_tr(1));
  const Picture four = render_picture(*scene, orthographic(2.0), with_tr(4));
  EXPECT_EQ(one.film.split_level, four.film.split_level);
  EXPECT_EQ(one.statistics.pyrays_by_level, four.statistics.pyrays_by_level);
  EXPECT_EQ(one.statistics.split_pixels, four.statistics.split_pixels);
  EXPECT_GT(four.statistics.eye_rays, one.statistics.eye_rays);
  // The post has no texture, so its pixels do not change.
  const std::size_t inside = four.film.index(11, 12);
  EXPECT_EQ(four.film.radiance[inside], one.film.radiance[inside]);
}

TEST(TextureResolution, WeightsAddUpToAPixel) {
  // A constant texture gives a constant picture, however leaves are divided and cut.
  World world = checks(true);
  for (std::uint8_t& byte : world.images[0].rgba.own()) byte = 255;
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = with_tr(1);
  const Picture one = render_picture(*scene, orthographic(2.0), settings);
  for (const LeafKind leaf : {LeafKind::exact, LeafKind::point}) {
    settings.asos.leaf = leaf;
    settings.texture.resolution = 1;
    const Picture expected = render_picture(*scene, orthographic(2.0), settings);
    settings.texture.resolution = 5;
    const Picture found = render_picture(*scene, orthographic(2.0), settings);
    for (std::size_t i = 0; i < found.film.radiance.size(); ++i)
      EXPECT_NEAR(found.film.radiance[i].r, expected.film.radiance[i].r, 1e-5f);
  }
  const View view(orthographic(2.0), picture_side, picture_side);
  for (int x = 0; x < picture_side; ++x) {
    const PixelTrace trace = trace_pixel(*scene, view, with_tr(4), x, 9);
    double weight = 0.0;
    for (const TracedCell& cell : trace.cells)
      for (const TracedSample& sample : cell.samples) weight += sample.weight;
    EXPECT_NEAR(weight, 1.0, 1e-6) << x;
  }
}

// A colour ramp that a slanted post cuts: the visible rest of a pixel has its own mean. Equally
// weighted samples at the quarters' centres would miss it by at least 1/32.
TEST(TextureResolution, LeavesWhatBoundariesCutToTheirOwnAreas) {
  World world;
  Material m = unlit(glm::vec3(1.0f));
  const Image two = make_image(2, 1, [](int x, int) {
    const auto grey = static_cast<std::uint8_t>(x == 0 ? 0 : 255);
    return Texel{grey, grey, grey, 255};
  });
  m.base_color_texture.texture = add_texture(world, two, Wrap::clamp_to_edge, Filter::linear);
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, m);
  // Between the texel centres: from black on the left to white on the right.
  for (glm::vec2& uv : world.texcoords[0]) uv.x = 0.25f + 0.5f * uv.x;
  constexpr float left = -0.33f, slant = 0.1f;
  add_quad(world, {left, -3, 1}, {0.5f, slant, 0}, {0, 6, 0}, unlit(glm::vec3(0.0f)));
  add_quad(world, {-3, -1.7f, 1.5f}, {6, 0.9f, 0}, {0, 1, 0}, unlit(glm::vec3(0.0f)));
  const auto scene = filtered_scene(std::move(world));
  const auto seen = [&](double x, double y) {
    const bool post = x > static_cast<double>(left) && x < static_cast<double>(left) + 0.5;
    const double low = -1.7 + 0.15 * (x + 3.0);
    return post || (y > low && y < low + 1.0) ? 0.0 : 0.5 * (x + 1.0);
  };
  constexpr int n = 200;
  constexpr double pixel = 2.0 / picture_side;
  for (const int tr : {1, 2, 4}) {
    RenderSettings settings = with_tr(tr);
    settings.texture.filter = TextureFilter::footprint;
    const Picture found = render_picture(*scene, orthographic(2.0), settings);
    for (const int y : {picture_side / 2, picture_side - 5}) {
      for (int x = 0; x < picture_side; ++x) {
        double sum = 0.0;
        for (int i = 0; i < n; ++i) {
          for (int k = 0; k < n; ++k)
            sum += seen(-1.0 + pixel * (x + (i + 0.5) / n), 1.0 - pixel * (y + (k + 0.5) / n));
        }
        EXPECT_NEAR(found.film.radiance[found.film.index(x, y)].r, sum / (n * n), 3e-3)
            << "TR " << tr << ", pixel " << x << ' ' << y;
      }
    }
  }
}

// A texture that changes its colour where it becomes hidden, like textures beyond their seams. The
// hidden part must hardly contribute to a pixel on the seam.
TEST(TextureResolution, HiddenPartsOfTexturesDoNotContribute) {
  World world;
  Material m = unlit(glm::vec3(1.0f));
  const Image halves = make_image(256, 1, [](int x, int) {
    const auto grey = static_cast<std::uint8_t>(x < 128 ? 255 : 0);
    return Texel{grey, grey, grey, 255};
  });
  m.base_color_texture.texture = add_texture(world, halves, Wrap::clamp_to_edge, Filter::linear);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  // White up to a slanted line that is the border of a post.
  const auto beyond = [](glm::dvec2 p) { return p.x - 0.03 - 0.7 * p.y; };
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 corner(world.positions[i].x, world.positions[i].y);
    world.texcoords[0][i].x = static_cast<float>(0.5 + 0.5 * beyond(corner));
  }
  add_quad(world, {0.03f - 2.1f, -3, 1}, {4, 0, 0}, {4.2f, 6, 0}, unlit(glm::vec3(0.3f)));
  const auto scene = filtered_scene(std::move(world));
  RenderSettings settings = with_tr(1);
  settings.texture.filter = TextureFilter::footprint;
  const Picture found = render_picture(*scene, orthographic(2.0), settings);
  constexpr int n = 200;
  constexpr double pixel = 2.0 / picture_side;
  double worst = 0.0;
  for (int x = 0; x < picture_side; ++x) {
    const int y = x;
    for (const int beside : {-2, -1, 0, 1, 2}) {
      const int column = std::clamp(picture_side / 2 + (picture_side / 2 - y) * 7 / 10 + beside, 0,
                                    picture_side - 1);
      double white = 0.0;
      for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k)
          white += beyond({-1.0 + pixel * (column + (i + 0.5) / n),
                           1.0 - pixel * (y + (k + 0.5) / n)}) < 0.0
                       ? 1.0
                       : 0.0;
      }
      const double expected = 0.3 + 0.7 * white / (n * n);
      const auto seen = static_cast<double>(found.film.radiance[found.film.index(column, y)].r);
      worst = std::max(worst, std::abs(seen - expected));
    }
  }
  EXPECT_LT(worst, 0.02);
}

TEST(TextureResolution, ATraceAddsUpToThePicture) {
  const auto scene = make_render_scene(checks(true));
  const RenderSettings settings = with_tr(4);
  const Picture picture = render_picture(*scene, orthographic(2.0), settings);
  const View view(orthographic(2.0), picture_side, picture_side);
  for (int x = 4; x < 16; ++x) {
    const PixelTrace trace = trace_pixel(*scene, view, settings, x, 12);
    glm::dvec3 sum(0.0);
    for (const TracedCell& cell : trace.cells)
      for (const TracedSample& sample : cell.samples)
        sum += sample.weight * glm::dvec3(sample.radiance);
    EXPECT_NEAR(sum.r, static_cast<double>(picture.film.radiance[picture.film.index(x, 12)].r),
                1e-5)
        << x;
  }
}

TEST(TextureResolution, DoesNotDependOnWhichBlocksAreRendered) {
  const auto scene = make_render_scene(checks(true));
  RenderSettings settings = with_tr(3);
  const Picture whole = render_picture(*scene, orthographic(2.0), settings);
  // Other fat pyrays have other frames, but the same random places up to rounding.
  settings.asos.fat = 4;
  const Picture other = render_picture(*scene, orthographic(2.0), settings);
  int differ = 0;
  for (std::size_t i = 0; i < whole.film.radiance.size(); ++i)
    differ += glm::distance(whole.film.radiance[i], other.film.radiance[i]) > 1e-3f ? 1 : 0;
  EXPECT_EQ(differ, 0);
  const View view(orthographic(2.0), picture_side, picture_side);
  settings.asos.fat = 8;
  const BlockResult again = render_block(*scene, view, settings, {8, 8, 8, 8});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(again.tile.radiance[static_cast<std::size_t>(8 * y + x)],
                whole.film.radiance[whole.film.index(8 + x, 8 + y)]);
}

// A constant texture, in the shadows of a post under a sphere light and a sun. The parts of a leaf
// share one shadow test, with the same result as one test each.
TEST(TextureResolution, PartsShareTheirShadows) {
  World world;
  Material m = matte(glm::vec3(0.6f));
  m.base_color_texture.texture = add_texture(world,
                                             make_image(1, 1,
                                                        [](int, int) {
                                                          return Texel{255, 255, 255, 255};
                                                        }),
                                             Wrap::repeat, Filter::nearest);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  add_quad(world, {-0.33f, -3, 0.6f}, {0.5f, 0.1f, 0}, {0, 6, 0}, matte(glm::vec3(0.3f)));
  const Light ball = make_bulb({-1.5, 0.4, 3.0}, 6.0f, 0.4);
  const Light sun = make_sun(glm::normalize(glm::dvec3(-0.7, 0.1, -1.0)));
  const auto scene = make_render_scene(std::move(world), {ball, sun});
  // EPS 0, because otherwise these lights get only a few rays and penumbrae are sampled.
  const auto exact = [](int tr) {
    RenderSettings settings = with_tr(tr);
    settings.asos.eps = 0.0;
    settings.asos.refine_shading = false;
    return settings;
  };
  const Picture once = render_picture(*scene, orthographic(2.0), exact(1));
  const Picture parts = render_picture(*scene, orthographic(2.0), exact(4));
  EXPECT_GT(parts.statistics.eye_rays, 10 * once.statistics.eye_rays);
  EXPECT_LT(parts.statistics.shadow_rays, 5 * once.statistics.shadow_rays);
  double worst = 0.0;
  for (std::size_t i = 0; i < once.film.radiance.size(); ++i)
    worst = std::max(
        worst, static_cast<double>(glm::length(once.film.radiance[i] - parts.film.radiance[i])));
  EXPECT_LT(worst, 4e-3) << "the tolerance at MAX 3";
}

TEST(TextureResolution, SmallLeavesAreDividedLess) {
  EXPECT_EQ(texture_divisions(1, 1.0), 1);
  EXPECT_EQ(texture_divisions(4, 1.0), 4);
  EXPECT_EQ(texture_divisions(4, 0.5), 2);
  EXPECT_EQ(texture_divisions(3, 0.5), 2) << "no part is larger than 1/9 pixel";
  EXPECT_EQ(texture_divisions(4, 0.25000001), 1);
  EXPECT_EQ(texture_divisions(8, 1.0 / 16.0), 1);
}

TEST(TextureResolution, PartsLieInTheirStrataAndInTheLeaf) {
  const Square square{0.25f, 0.5f, 0.125f};
  const auto all = texture_parts(square, 5, {{16, 8}, 8}, 0, true);
  ASSERT_EQ(all.size(), 25u);
  std::set<float> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const glm::vec2 within = (all[i].at - glm::vec2(square.u, square.v)) / square.side * 5.0f;
    EXPECT_EQ(static_cast<std::size_t>(within.x), i % 5);
    EXPECT_EQ(static_cast<std::size_t>(within.y), i / 5);
    places.insert(within.x - std::floor(within.x));
  }
  EXPECT_GT(places.size(), 20u) << "places are jittered independently";
  for (const TexturePart& part : texture_parts(square, 5, {{16, 8}, 8}, 0, false)) {
    EXPECT_FLOAT_EQ(part.at.x, part.square.centre_u());
    EXPECT_FLOAT_EQ(part.at.y, part.square.centre_v());
  }
  // Another frame around the same pixel, and another seed.
  const auto moved = texture_parts({0.5f, 0.5f, 0.25f}, 5, {{16, 10}, 4}, 0, true);
  const auto reseeded = texture_parts(square, 5, {{16, 8}, 8}, 1, true);
  int same = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(8.0f * all[i].at.x, 4.0f * moved[i].at.x, 1e-5f);
    EXPECT_NEAR(8.0f * all[i].at.y, 2.0f + 4.0f * moved[i].at.y, 1e-5f);
    same += all[i].at == reseeded[i].at ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
}

TEST(TextureResolution, KnowsWhatIsTextured) {
  RenderFeatures render_features;
  render_features.textures = render_features.normal_maps = render_features.emission = true;
  Material m;
  EXPECT_FALSE(is_textured(m, render_features));
  for (TextureUse Material::*use :
       {&Material::base_color_texture, &Material::metallic_roughness_texture,
        &Material::normal_texture, &Material::emissive_texture}) {
    Material one;
    (one.*use).texture = 0;
    EXPECT_TRUE(is_textured(one, render_features));
    one.unlit = true;
    EXPECT_EQ(is_textured(one, render_features), use == &Material::base_color_texture);
  }
}

}  // namespace
}  // namespace asos::test::texture_resolution_test
