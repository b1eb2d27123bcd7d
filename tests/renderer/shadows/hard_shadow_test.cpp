#include "tests/support/make_light.h"
#include "tests/support/polygon.h"
#include "tests/support/random_space.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

// Hard shadows of point, spot and directional lights on a pixel or a leaf's part of one: the lit
// fraction of its area, as seen by the viewer.

namespace asos::test::hard_shadow_test {
namespace {

constexpr double floor_half = 20.0;

/// A pixel that shows the floor z = 0.
struct Pixel {
  Frame frame;
  Polygon3 patch;  ///< the leaf's region on the floor
  Polygon region;  ///< the same region in the frame
  Square square;
};

glm::dvec2 projected(const Frame& frame, glm::dvec3 p) {
  const FramePoint at = frame.project(frame.homogeneous(p));
  return {at.u, at.v};
}

/// A leaf of a random pixel: a whole pixel, a 1/16 cell, or a part cut by an outline. Returns
/// nothing if a part of it shows no floor.
std::optional<Pixel> random_pixel(RandomSpace& random, int kind, Camera::Type eye_type) {
  const glm::dvec3 target(random.between(-2, 2), random.between(-2, 2), 0);
  // From straight above down to less than a degree.
  const double elevation = kind % 3 ? random.between(0.2, 1.5) : random.between(0.01, 0.1);
  const double azimuth = random.between(0, 2 * std::numbers::pi);
  const glm::dvec3 back(std::cos(azimuth) * std::cos(elevation),
                        std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const double distance = random.between(1.0, 6.0);
  const double size = std::pow(10.0, random.between(-4.0, -1.5));
  const glm::dvec3 right = size * random.perpendicular(back), down = glm::cross(right, back);
  const glm::dvec3 eye = target + distance * back;
  const Frame frame = eye_type == Camera::Type::orthographic
                          ? Frame::prism(eye - 0.5 * (right + down), -back, right, down)
                          : Frame::pyramid(eye, -back - 0.5 * (right + down), right, down);
  Square square{0, 0, 1};
  if (kind % 4 == 1) square = {0.25f, 0.5f, 0.25f};
  const double u = square.u, v = square.v, s = square.side;
  Polygon region{{u, v}, {u + s, v}, {u + s, v + s}, {u, v + s}};
  if (kind % 4 > 1) {
    const double angle = random.between(0, 2 * std::numbers::pi);
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    const double offset = random.between(-0.3, 0.3);
    region = clip(region, [&](glm::dvec2 p) { return glm::dot(normal, p - 0.5) - offset; });
    for (glm::dvec2& p : region) p = glm::dvec2(glm::vec2(p));
  }
  const auto on_floor = [&](glm::dvec2 p) { return frame.on_plane(p, {{0, 0, 1}, 0}); };
  // If a corner of the square shows no floor, a single ray decides for the whole leaf.
  for (const glm::dvec2& p : {glm::dvec2(u, v), {u + s, v}, {u, v + s}, {u + s, v + s}}) {
    const auto at = on_floor(p);
    if (!at || glm::length(*at) > floor_half) return std::nullopt;
  }
  Polygon3 patch;
  for (const glm::dvec2& p : region) patch.push_back(*on_floor(p));
  return Pixel{frame, patch, region, square};
}

/// The part of a convex polygon that a convex flat occluder shadows from parallel light.
Polygon3 hidden_along(Polygon3 polygon, const Polygon3& occluder, glm::dvec3 towards) {
  const glm::dvec3 face = glm::cross(occluder[1] - occluder[0], occluder[2] - occluder[0]);
  const double side = glm::dot(face, towards) > 0.0 ? 1.0 : -1.0;
  polygon = clip(polygon, -side * face, occluder[0]);
  for (std::size_t i = 0; i < occluder.size(); ++i) {
    const glm::dvec3 edge = occluder[(i + 1) % occluder.size()] - occluder[i];
    polygon = clip(polygon, side * glm::cross(towards, edge), occluder[i]);
  }
  return polygon;
}

/// Whether the screen rises from the floor within the patch: then the viewer sees more than the
/// floor.
bool stands_in(const Polygon3& screen, const Polygon3& patch) {
  const glm::dvec3 normal = glm::cross(screen[1] - screen[0], screen[2] - screen[0]);
  const auto straddles = [](const Polygon3& polygon, glm::dvec3 n, glm::dvec3 origin) {
    std::size_t above = 0;
    for (const glm::dvec3& p : polygon) above += glm::dot(n, p - origin) > 0.0;
    return above > 0 && above < polygon.size();
  };
  return straddles(patch, normal, screen[0]) && straddles(screen, {0, 0, 1}, patch[0]);
}

double area_in(const Frame& frame, const Polygon3& patch) {
  Polygon flat;
  for (const glm::dvec3& p : patch) flat.push_back(projected(frame, p));
  return flat.size() < 3 ? 0.0 : area(flat);
}

double visibility(ShadowFixture& fixture, const Pixel& pixel, int kind, float triangle_size) {
  SurfacePoint point;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : pixel.patch) middle += p / static_cast<double>(pixel.patch.size());
  point.position = glm::vec3(middle);
  point.error = glm::vec3(1e-6f, 1e-6f, 0.0f);
  point.geometric_normal = point.shading_normal = {0, 0, 1};
  point.extent = triangle_size;
  point.triangle = 0;
  std::vector<BorderEdge> sides;
  if (kind % 4 > 1) {
    for (std::size_t i = 0; i < pixel.region.size(); ++i)
      sides.push_back(
          {glm::vec2(pixel.region[i]), glm::vec2(pixel.region[(i + 1) % pixel.region.size()])});
  }
  return fixture.visibility(point, pixel.frame, leaf_of({pixel.square, sides}, 1.0f, 7));
}

/// How the floor is seen, and the size of its triangles: shadow rays end farther above larger ones.
struct Shown {
  Camera::Type eye = Camera::Type::perspective;
  float triangle_size = 0.1f;
};

/// For random pixels: a large screen with the edge of its shadow in the pixel.
void expect_edges(std::uint64_t seed, Shown shown, Light (*make)(RandomSpace&)) {
  RandomSpace random(seed);
  double worst = 0.0;
  int partly = 0, off = 0;
  ShadowRules settings{.error_budget = {.max_level = 4}};
  for (int i = 0; i < 600; ++i) {
    const Light light = make(random);
    const auto pixel = random_pixel(random, i, shown.eye);
    if (!pixel || pixel->region.size() < 3) continue;
    const bool distant = light.type == Light::Type::directional;
    glm::dvec3 inside(0.0);
    double sum = 0.0;
    for (const glm::dvec3& p : pixel->patch) {
      const double weight = random.between(0, 1);
      inside += weight * p;
      sum += weight;
    }
    inside /= sum;
    const glm::dvec3 way = distant ? -5.0 * light.direction : light.position - inside;
    const glm::dvec3 through = inside + random.between(0.05, 0.7) * way;
    const glm::dvec3 edge = random.direction();
    World world;
    const auto f = static_cast<float>(floor_half);
    add_quad(world, {-f, -f, 0}, {2 * f, 0, 0}, {0, 2 * f, 0}, matte({0.5f, 0.5f, 0.5f}));
    const double wide = i % 2 ? 8.0 : 0.05;
    const Polygon3 screen = add_occluder(world, through - 0.5 * wide * edge, wide * edge,
                                         wide * random.perpendicular(edge));
    if (stands_in(screen, pixel->patch)) continue;
    ShadowFixture fixture(std::move(world), light, settings);
    const Polygon3 hidden = distant ? hidden_along(pixel->patch, screen, -light.direction)
                                    : hidden_part(pixel->patch, screen, light.position);
    const double exact = 1.0 - area_in(pixel->frame, hidden) / area_in(pixel->frame, pixel->patch);
    const double found = visibility(fixture, *pixel, i, shown.triangle_size);
    EXPECT_NEAR(found, exact, 1e-4) << i;
    worst = std::max(worst, std::abs(found - exact));
    off += std::abs(found - exact) > 1e-4;
    partly += exact > 0.01 && exact < 0.99;
  }
  testing::Test::RecordProperty("worst_error", testing::PrintToString(worst));
  testing::Test::RecordProperty("leaves_off", off);
  EXPECT_GT(partly, 200);
}

Light bulb(RandomSpace& random) {
  return {.position = {random.between(-3, 3), random.between(-3, 3), random.between(1, 5)}};
}

Light spot(RandomSpace& random) {
  Light light = bulb(random);
  light.type = Light::Type::spot;
  light.direction = glm::normalize(-light.position);
  light.outer_cone_rad = 1.5;
  return light;
}

Light distant(RandomSpace& random) {
  Light light{.type = Light::Type::directional};
  do light.direction = random.direction();
  while (light.direction.z > -0.1);
  return light;
}

TEST(HardShadow, OfAPointLightCoversItsExactShareOfALeaf) {
  expect_edges(1, {}, bulb);
  expect_edges(2, {Camera::Type::orthographic}, bulb);
}

TEST(HardShadow, OfASpotCoversItsExactShareOfALeaf) {
  expect_edges(3, {}, spot);
}

TEST(HardShadow, OfADirectionalLightCoversItsExactShareOfALeaf) {
  expect_edges(4, {Camera::Type::orthographic}, distant);
}

TEST(HardShadow, OfADirectionalLightUnderAPerspectiveEyeIsExact) {
  expect_edges(5, {}, distant);
}

// Shadow rays end farther above large triangles, but still on the line to the light.
TEST(HardShadow, DoesNotMoveOnLargeTriangles) {
  expect_edges(6, {Camera::Type::perspective, 40.0f}, bulb);
  expect_edges(7, {Camera::Type::orthographic, 40.0f}, distant);
}

// So many specks that MAX cannot resolve them and cuts are too expensive: they shadow half of the
// pixel, which is sampled to EPS.
TEST(HardShadow, ManySpecksAreSampledToEps) {
  constexpr int count = 12;
  constexpr double space = 1.0 / count;
  const double size = std::sqrt(0.5) * space;
  for (const int max_level : {3, 4, 5}) {
    RenderSettings settings{.asos = {.max_level = max_level, .eps = 1.0 / 256.0}};
    ShadowRules rules{.error_budget = ErrorBudget::of(settings)};
    World world;
    const auto f = static_cast<float>(floor_half);
    add_quad(world, {-f, -f, 0}, {2 * f, 0, 0}, {0, 2 * f, 0}, matte({0.5f, 0.5f, 0.5f}));
    for (int i = 0; i < count * count; ++i)
      add_occluder(world, {i % count * space, i / count * space, 0.5}, {size, 0, 0}, {0, size, 0});
    const Light sun = make_sun({0, 0, -1});
    ShadowFixture fixture(std::move(world), sun, rules);
    const Pixel pixel{Frame::prism({0, 0, 2}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}),
                      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                      {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                      {0, 0, 1}};
    EXPECT_NEAR(visibility(fixture, pixel, 0, 0.1f), 0.5, 1.0 / 256.0) << "MAX " << max_level;
  }
}

}  // namespace
}  // namespace asos::test::hard_shadow_test
