#include "tests/support/make_light.h"
#include "tests/support/polygon.h"
#include "tests/support/random_space.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Light of a point, spot or directional light behind a masked or blended card, on a pixel that
// shows the floor z = 0, against the projected and clipped shadows of its texels.

namespace asos::test::cut_out_hard_shadow_test {
namespace {

/// Which of n x n texels are opaque.
struct Pattern {
  const char* name;
  int texels;
  bool (*opaque)(int x, int y);
};

constexpr Pattern patterns[] = {
    {"checker", 4, [](int x, int y) { return (x + y) % 2 == 1; }},
    {"comb", 8, [](int x, int /*y*/) { return x % 2 == 0; }},
    {"hole", 5, [](int x, int y) { return x != 2 || y != 2; }},
    {"dot", 5, [](int x, int y) { return x == 2 && y == 2; }},
    {"leaves", 8, [](int x, int y) { return (x * x + 3 * y * y + 5 * x * y) % 7 < 3; }},
};

struct Card {
  glm::dvec3 corner, a, b;
};

/// Adds a card with a pattern; returns its opaque texels.
std::vector<Polygon3> add_card(World& world, const Card& card, const Pattern& pattern) {
  const int n = pattern.texels;
  Material material = matte({1, 1, 1});
  material.alpha_mode = AlphaMode::mask;
  material.base_color_texture.texture = add_texture(
      world,
      make_image(
          n, n,
          [&](int x, int y) -> Texel {
            return {255, 255, 255, static_cast<std::uint8_t>(pattern.opaque(x, y) ? 255 : 0)};
          }),
      Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, glm::vec3(card.corner), glm::vec3(card.a), glm::vec3(card.b), material);
  std::vector<Polygon3> opaque;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (!pattern.opaque(x, y)) continue;
      const auto at = [&](int i, int j) {
        return card.corner +
               (1.0 / n) * (static_cast<double>(i) * card.a + static_cast<double>(j) * card.b);
      };
      opaque.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return opaque;
}

Light bulb() {
  return {.position = {0.3, -0.2, 2.5}};
}

Light spot() {
  Light light = bulb();
  light.type = Light::Type::spot;
  light.direction = glm::normalize(-light.position);
  light.outer_cone_rad = 1.2;
  return light;
}

Light distant() {
  return make_sun(glm::normalize(glm::dvec3(-0.2, 0.1, -1.0)));
}

/// A pixel that shows about half a unit of the floor around `target`.
Frame pixel_at(glm::dvec3 target) {
  const glm::dvec3 eye = target + glm::dvec3(1.5, -2.0, 2.5);
  const glm::dvec3 back = glm::normalize(eye - target);
  const glm::dvec3 right = 0.15 * glm::normalize(glm::cross(glm::dvec3(0, 0, 1), back));
  const glm::dvec3 down = glm::cross(right, back);
  return Frame::pyramid(eye, -back - 0.5 * (right + down), right, down);
}

/// The part of the pixel, in its frame, that a flat piece shadows.
Polygon shadow_in(const Frame& pixel, const Polygon3& piece, const Light& light) {
  Polygon3 shadow;
  for (const glm::dvec3& p : piece) {
    const glm::dvec3 way =
        light.type == Light::Type::directional ? light.direction : p - light.position;
    shadow.push_back(p - p.z / way.z * way);
  }
  // Clips to the visible part of the floor: points behind the viewer have no place in the frame.
  constexpr glm::dvec2 corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto on_floor = [&](glm::dvec2 at) { return *pixel.on_plane(at, {{0, 0, 1}, 0.0}); };
  const glm::dvec3 middle = on_floor({0.5, 0.5});
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 p = on_floor(corners[i]), q = on_floor(corners[(i + 1) % 4]);
    const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), q - p);
    shadow = clip(shadow, glm::dot(across, middle - p) > 0.0 ? across : -across, p);
  }
  Polygon flat;
  for (const glm::dvec3& p : shadow) {
    const FramePoint at = pixel.project(pixel.homogeneous(p));
    flat.emplace_back(at.u, at.v);
  }
  return flat;
}

double visibility(ShadowFixture& fixture, const Frame& pixel, std::uint64_t seed) {
  SurfacePoint point{.position = glm::vec3(*pixel.on_plane({0.5, 0.5}, {{0, 0, 1}, 0.0})),
                     .error = glm::vec3(1e-6f, 1e-6f, 0.0f)};
  point.geometric_normal = point.shading_normal = {0, 0, 1};
  point.extent = 0.1f;
  point.triangle = 0;
  return fixture.visibility(point, pixel, leaf_of({{0.0f, 0.0f, 1.0f}, {}}, 1.0f, seed));
}

World floor_world() {
  World world;
  add_quad(world, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, matte({0.5f, 0.5f, 0.5f}));
  return world;
}

/// Total area of the finest cells that outlines may cross, as a fraction of the pixel.
double marginal_area(const std::vector<Polygon>& shadows, double side) {
  double area = 0.0;
  for (const Polygon& shadow : shadows) {
    for (std::size_t i = 0; i < shadow.size(); ++i) {
      const glm::dvec2 step = glm::abs(shadow[(i + 1) % shadow.size()] - shadow[i]);
      area += side * (step.x + step.y + side);
    }
  }
  return area;
}

struct Errors {
  double mean = 0.0;
  int partly = 0;  ///< pixels that are neither fully lit nor fully shadowed
};

/// Errors over pixels in one cut-out's shadow. Without known outlines, each pixel's error is
/// limited by the area of the finest cells that outlines cross, which have one sample each.
Errors errors_at(int max_level, const Light& light, const Pattern& pattern, bool outlined) {
  ShadowRules settings{.error_budget = {.max_level = max_level}};
  World world = floor_world();
  const std::vector<Polygon3> opaque =
      add_card(world, {{-0.5, -0.5, 0.9}, {1.0, 0.1, 0.2}, {-0.1, 1.0, 0.1}}, pattern);
  if (!outlined) leave_cut_outs_to_samples(world);
  ShadowFixture fixture(std::move(world), light, settings);
  RandomSpace random(11);
  Errors errors;
  constexpr int count = 80;
  for (int i = 0; i < count; ++i) {
    const Frame pixel = pixel_at({random.between(-1.0, 0.8), random.between(-0.8, 0.8), 0.0});
    std::vector<Polygon> shadows;
    double shaded = 0.0;
    for (const Polygon3& texel : opaque) {
      shadows.push_back(shadow_in(pixel, texel, light));
      shaded += area(shadows.back());
    }
    const double off =
        std::abs(visibility(fixture, pixel, static_cast<std::uint64_t>(i)) - (1.0 - shaded));
    const double bound = outlined ? 0.0 : marginal_area(shadows, std::ldexp(1.0, -max_level));
    EXPECT_LE(off, bound + 1e-4) << pattern.name << ' ' << max_level << ' ' << i;
    errors.mean += off / count;
    errors.partly += shaded > 0.02 && shaded < 0.98;
  }
  return errors;
}

// With known outlines, the sides of texels are edges that cut the shadow.
TEST(CutOutHardShadow, IsExactForOutlinedCutOuts) {
  for (const Light& light : {bulb(), spot(), distant()}) {
    for (const Pattern& pattern : patterns) {
      for (const int max_level : {2, 4}) {
        const Errors errors = errors_at(max_level, light, pattern, true);
        EXPECT_GE(errors.partly, 5) << pattern.name;
        EXPECT_LT(errors.mean, 1e-6) << pattern.name;
      }
    }
  }
}

// Another cut-out, far away, that is left to samples does not matter.
TEST(CutOutHardShadow, IsExactNextToSampledCutOuts) {
  const Light light = bulb();
  const auto rays_of = [&](bool others) {
    World world = floor_world();
    add_card(world, {{-0.5, -0.5, 0.9}, {1.0, 0.1, 0.2}, {-0.1, 1.0, 0.1}}, patterns[0]);
    if (others) {
      add_card(world, {{15, 15, 0.9}, {1, 0, 0}, {0, 1, 0}}, patterns[0]);
      world.colors.assign(world.positions.size(), glm::vec4(1.0f));
      world.colors.back().a = 0.9f;
    }
    ShadowRules settings{.error_budget = {.max_level = 4}};
    ShadowFixture fixture(std::move(world), light, settings);
    EXPECT_EQ(fixture.features().cut_outs_unbounded(), others);
    RandomSpace random(11);
    for (int i = 0; i < 40; ++i) {
      const Frame pixel = pixel_at({random.between(-0.4, 0.4), random.between(-0.4, 0.4), 0.0});
      (void)visibility(fixture, pixel, static_cast<std::uint64_t>(i));
    }
    return fixture.counts().shadow_rays;
  };
  EXPECT_LT(rays_of(true), 2 * rays_of(false));
}

// The samples of crossed cells have random errors, so their sum falls with the cells' side to the
// power of 3/2: to an eighth over two levels. Requires half of that reduction.
TEST(CutOutHardShadow, ErrorOfSampledCutOutsFallsWithMax) {
  for (const Light& light : {bulb(), spot(), distant()}) {
    for (const Pattern& pattern : patterns) {
      std::vector<double> means;
      for (int max_level = 1; max_level <= 5; ++max_level) {
        const Errors errors = errors_at(max_level, light, pattern, false);
        EXPECT_GE(errors.partly, 5) << pattern.name;
        means.push_back(errors.mean);
        RecordProperty(std::string(pattern.name) + "_" +
                           std::to_string(static_cast<int>(light.type)) + "_" +
                           std::to_string(max_level),
                       testing::PrintToString(errors.mean));
      }
      for (std::size_t i = 2; i < means.size(); ++i)
        EXPECT_LT(means[i], 0.5 * means[i - 2]) << pattern.name << ' ' << i;
      EXPECT_LT(means.back(), 0.005) << pattern.name;
    }
  }
}

/// Mean light over a pixel behind sheets with these shadows, each with the transmittance `through`:
/// by inclusion and exclusion over the overlaps.
double left_behind(const Polygon& region, const std::vector<Polygon>& sheets,
                   const std::vector<double>& through, std::size_t first = 0) {
  if (region.size() < 3) return 0.0;
  double left = area(region);
  for (std::size_t i = first; i < sheets.size(); ++i) {
    if (sheets[i].size() < 3) continue;
    Polygon overlap = region;
    for (std::size_t k = 0; k < sheets[i].size() && overlap.size() > 2; ++k) {
      const glm::dvec2 p = sheets[i][k], q = sheets[i][(k + 1) % sheets[i].size()];
      double turn = 0.0;
      for (std::size_t m = 0; m < sheets[i].size(); ++m) {
        const glm::dvec2 s = sheets[i][m], t = sheets[i][(m + 1) % sheets[i].size()];
        turn += s.x * t.y - s.y * t.x;
      }
      const double sign = turn < 0.0 ? -1.0 : 1.0;
      overlap = clip(overlap, [&](glm::dvec2 r) {
        return sign * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
      });
    }
    // Expands the product of (1 - a_i inside_i): each overlap subtracts a_i times the light that
    // the later sheets leave there.
    left -= (1.0 - through[i]) * left_behind(overlap, sheets, through, i + 1);
  }
  return left;
}

// Three sheets whose edges cross within the pixels.
TEST(BlendedHardShadow, MultipliesTheTransmittanceOfSheets) {
  const std::vector<double> through{0.75, 0.5, 0.125};
  for (const Light& light : {bulb(), spot(), distant()}) {
    World world = floor_world();
    std::vector<Polygon3> sheets;
    const Card cards[] = {{{-2, -0.05, 0.5}, {3, 0.3, 0}, {-0.2, 2, 0.1}},
                          {{0.02, -2, 0.8}, {2, 0, 0.2}, {0.1, 4, 0}},
                          {{-1.5, -1.2, 1.1}, {2.5, 2.2, 0}, {-2, 2, 0}}};
    for (std::size_t i = 0; i < through.size(); ++i) {
      Material material = matte({1, 1, 1});
      material.alpha_mode = AlphaMode::blend;
      material.base_color.a = static_cast<float>(1.0 - through[i]);
      const Card& card = cards[i];
      add_quad(world, glm::vec3(card.corner), glm::vec3(card.a), glm::vec3(card.b), material);
      sheets.push_back(
          {card.corner, card.corner + card.a, card.corner + card.a + card.b, card.corner + card.b});
    }
    ShadowFixture fixture(std::move(world), light);
    RandomSpace random(12);
    double worst = 0.0;
    int partly = 0;
    for (int i = 0; i < 200; ++i) {
      const Frame pixel = pixel_at({random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0});
      std::vector<Polygon> shadows;
      for (const Polygon3& sheet : sheets) shadows.push_back(shadow_in(pixel, sheet, light));
      const double exact = left_behind({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, shadows, through);
      const double found = visibility(fixture, pixel, static_cast<std::uint64_t>(i));
      EXPECT_NEAR(found, exact, 1e-4) << i;
      worst = std::max(worst, std::abs(found - exact));
      for (const Polygon& shadow : shadows) partly += area(shadow) > 0.02 && area(shadow) < 0.98;
    }
    EXPECT_GT(partly, 100);
    RecordProperty("worst_error_" + std::to_string(static_cast<int>(light.type)),
                   testing::PrintToString(worst));
  }
}

}  // namespace
}  // namespace asos::test::cut_out_hard_shadow_test
