#include "renderer/lights/prepared_light.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/shading/texture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

// Textured emissive triangles, quadrilaterals and meshes, against numerical integration of the
// texture over the triangles.

namespace asos::test::painted_shapes_test {
namespace {

constexpr float strength = 3.0f;

/// Red on the left, blue on the right.
Image halves() {
  return make_image(2, 1, [](int x, int) {
    return x == 0 ? Texel{255, 0, 0, 255} : Texel{0, 0, 255, 255};
  });
}

/// White; the left half is masked out.
Image half_masked() {
  return make_image(2, 1, [](int x, int) {
    return Texel{255, 255, 255, static_cast<std::uint8_t>(x == 0 ? 0 : 255)};
  });
}

Material painted(World& world, const Image& image, bool mask = false) {
  Material m{.emissive = glm::vec3(1.0f), .emissive_strength = strength};
  const int texture = add_texture(world, image, Wrap::clamp_to_edge, Filter::nearest);
  (mask ? m.base_color_texture : m.emissive_texture).texture = texture;
  if (mask) m.alpha_mode = AlphaMode::mask;
  return m;
}

/// A fan of triangles around the first of these corners in z = 0, 2 wide; u is 0 at x = -1 and 1 at
/// x = 1.
World fan(const std::vector<glm::vec2>& corners, const Image& image, bool mask = false) {
  World world;
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (const glm::vec2 p : corners)
    vertices.push_back({{p, 0}, {0, 0, 1}, {0.5f * p.x + 0.5f, 0.5f * p.y + 0.5f}});
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) triangles.emplace_back(0, i, i + 1);
  add_part(world, vertices, triangles, painted(world, image, mask));
  return world;
}

glm::dvec3 emission(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& m = world.materials[0];
  const bool mask = m.alpha_mode == AlphaMode::mask;
  const glm::vec4 texel = sample_texture(world, mask ? m.base_color_texture : m.emissive_texture,
                                         triangle, b1, b2, Encoding::srgb);
  if (mask) return glm::dvec3(texel.a >= 0.5f ? strength : 0.0f);
  return glm::dvec3(strength * glm::vec3(texel));
}

/// Irradiance of a point, summed over the centroids of many small triangles.
glm::dvec3 integral(const World& world, const Receiver& at, int steps) {
  glm::dvec3 sum(0.0);
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    const glm::uvec3 v = world.triangles[t];
    const glm::dvec3 p(world.positions[v.x]), e1 = glm::dvec3(world.positions[v.y]) - p,
                                              e2 = glm::dvec3(world.positions[v.z]) - p,
                                              across = glm::cross(e1, e2);
    const glm::dvec3 normal = glm::normalize(across);
    const double area = 0.5 * glm::length(across) / (steps * steps);
    const auto add = [&](double b1, double b2) {
      const glm::dvec3 way = p + b1 * e1 + b2 * e2 - at.position;
      const double square = glm::dot(way, way), length = std::sqrt(square);
      const double here = std::max(0.0, glm::dot(way, at.normal)) / length;
      const double there = std::max(0.0, -glm::dot(way, normal)) / length;
      sum += emission(world, t, static_cast<float>(b1), static_cast<float>(b2)) *
             (here * there / square * area);
    };
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; i + j < steps; ++j) {
        add((i + 1.0 / 3.0) / steps, (j + 1.0 / 3.0) / steps);
        if (i + j + 1 < steps) add((i + 2.0 / 3.0) / steps, (j + 2.0 / 3.0) / steps);
      }
    }
  }
  return sum;
}

glm::dvec3 by_lights(const World& world, const Receiver& at) {
  glm::dvec3 sum(0.0);
  for (const Light& light : lights_of_meshes(world))
    sum += glm::dvec3(unshadowed_irradiance(prepare_light(light, LightRule::physical), at));
  return sum;
}

void expect_integral(const World& world, double share, int steps = 200) {
  for (const glm::dvec3 place :
       {glm::dvec3(0, 0, 1), {-1, 0.3, 0.5}, {1.2, -0.8, 0.7}, {3, 1, 2}}) {
    const Receiver at{place, glm::normalize(glm::dvec3(0.2, 0.1, -1)), {0, 0, -1}};
    const glm::dvec3 expected = integral(world, at, steps), found = by_lights(world, at);
    const double most = std::max({expected.x, expected.y, expected.z});
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], share * most) << place.x << ' ' << c;
  }
}

const std::vector<glm::vec2> triangle{{-1, -1}, {1, -1}, {-0.3f, 0.8f}};
const std::vector<glm::vec2> quadrilateral{{-1, -0.5f}, {1, -0.9f}, {0.6f, 0.7f}, {-0.8f, 0.2f}};
const std::vector<glm::vec2> arrow{{0, -0.6f}, {1, 0.6f}, {0, 0.1f}, {-1, 0.6f}};

TEST(PaintedShapes, FlatFacesShineFromWhereTheyAre) {
  for (const auto& shape : {triangle, quadrilateral, arrow}) {
    const World world = fan(shape, halves());
    EXPECT_EQ(lights_of_meshes(world).size(), 2u);
    expect_integral(world, 3e-3);
  }
}

TEST(PaintedShapes, MaskedFacesShineWhereTheyAreThere) {
  for (const auto& shape : {triangle, quadrilateral, arrow})
    expect_integral(fan(shape, half_masked(), true), 3e-3);
}

TEST(PaintedShapes, DisksShineFromWhereTheyAre) {
  std::vector<glm::vec2> corners;
  constexpr int sides = 96;
  for (int i = 0; i < sides; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / sides;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  expect_integral(fan(corners, halves()), 5e-3, 30);
}

TEST(PaintedShapes, EvenFacesStayOneLight) {
  const Image even = make_image(4, 4, [](int, int) { return Texel{200, 100, 50, 255}; });
  for (const auto& shape : {triangle, quadrilateral, arrow}) {
    const World world = fan(shape, even);
    ASSERT_EQ(lights_of_meshes(world).size(), 1u);
    expect_integral(world, 3e-3);
  }
}

// One face of a cube has a pattern. The five uniform faces need one light each and leave it the
// rest.
TEST(PaintedShapes, FacesOfAPieceShareItsLights) {
  World world;
  const Image stripes = make_image(8, 1, [](int x, int) {
    return x % 3 == 0 ? Texel{255, 255, 255, 255} : Texel{0, 0, 0, 255};
  });
  const Material m = painted(world, stripes);
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  const auto face = [&](glm::vec3 corner, glm::vec3 a, glm::vec3 b, bool patterned) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const float s = patterned ? 1.0f : 0.0f;  // the others show the first texel
    const glm::vec3 n = glm::normalize(glm::cross(a, b));
    vertices.insert(vertices.end(), {{corner, n, {0, 0}},
                                     {corner + a, n, {s, 0}},
                                     {corner + a + b, n, {s, s}},
                                     {corner + b, n, {0, s}}});
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  };
  const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), lo(-0.5f, -0.5f, -1);
  face(lo + z, x, y, true);
  face(lo, y, x, false);
  face(lo, z, y, false);
  face(lo + x, y, z, false);
  face(lo, x, z, false);
  face(lo + y, z, x, false);
  add_part(world, vertices, triangles, m);
  EXPECT_EQ(lights_of_meshes(world).size(), 5u + 3u) << "three stripes are white";
  expect_integral(world, 5e-3, 100);
}

// A half pipe of 32 strips around the x axis, open towards +Z; u runs around it. Neighbouring
// rectangles differ by up to 30 degrees.
TEST(PaintedShapes, CurvedMeshesShineFromWhereTheyAre) {
  World world;
  const Material m = painted(world, halves());
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  constexpr std::uint32_t strips = 32;
  for (std::uint32_t i = 0; i <= strips; ++i) {
    const float u = static_cast<float>(i) / strips, angle = std::numbers::pi_v<float> * u;
    for (const float end : {-1.0f, 1.0f})
      vertices.push_back({{end, -std::cos(angle), -std::sin(angle)}, {0, 0, 1}, {u, 0.5f}});
  }
  for (std::uint32_t i = 0; i < strips; ++i) {
    triangles.emplace_back(2 * i, 2 * i + 1, 2 * i + 3);
    triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 2);
  }
  add_part(world, vertices, triangles, m);
  expect_integral(world, 0.06, 40);
}

// A single sphere light would be purple in all directions.
TEST(PaintedShapes, BallsOfTwoColoursShineFromWhereTheyAre) {
  World world;
  add_sphere(world, {0, 0, -1}, 0.7f, 16, painted(world, halves()));
  for (std::size_t i = 0; i < world.positions.size(); ++i)
    world.texcoords[0][i] = {0.5f * world.positions[i].x + 0.5f, 0.5f};
  expect_integral(world, 0.1, 6);
}

}  // namespace
}  // namespace asos::test::painted_shapes_test
