#include "renderer/lights/prepared_light.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/shading/texture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

// Emissive rectangles with a texture or a mask, against numerical integration of the texture over
// the rectangle.

namespace asos::test::textured_emitter_test {
namespace {

constexpr float width = 2.0f, height = 1.0f;

/// A rectangle in z = 0 that emits towards +Z.
World emitter(const Image& image, Filter filter, bool mask) {
  World world;
  Material m{.emissive = glm::vec3(1.0f), .emissive_strength = 3.0f};
  const int texture = add_texture(world, image, Wrap::clamp_to_edge, filter);
  if (mask) {
    m.base_color_texture.texture = texture;
    m.alpha_mode = AlphaMode::mask;
  } else {
    m.emissive_texture.texture = texture;
  }
  add_quad(world, {-width / 2, -height / 2, 0}, {width, 0, 0}, {0, height, 0}, m);
  return world;
}

/// Integrates the irradiance of a point over the centres of many small squares.
glm::dvec3 integral(const World& world, const Receiver& at, bool mask) {
  const Material& m = world.materials[0];
  constexpr int steps = 400;
  glm::dvec3 sum(0.0);
  for (int j = 0; j < steps; ++j) {
    for (int i = 0; i < steps; ++i) {
      const double u = (i + 0.5) / steps, v = (j + 0.5) / steps;
      // The quad's triangles: corners 0, 1, 2 and 0, 2, 3.
      const bool first = u >= v;
      const auto b1 = static_cast<float>(first ? u - v : u);
      const auto b2 = static_cast<float>(first ? v : v - u);
      const TextureUse& use = mask ? m.base_color_texture : m.emissive_texture;
      const glm::vec4 texel = sample_texture(world, use, first ? 0 : 1, b1, b2, Encoding::srgb);
      glm::dvec3 radiance(3.0f * glm::vec3(texel));
      if (mask) radiance = glm::dvec3(texel.a >= 0.5f ? 3.0 : 0.0);
      const glm::dvec3 place((u - 0.5) * width, (v - 0.5) * height, 0.0);
      const glm::dvec3 way = place - at.position;
      const double square = glm::dot(way, way), length = std::sqrt(square);
      const double here = std::max(0.0, glm::dot(way, at.normal)) / length;
      const double there = std::max(0.0, -way.z) / length;
      sum += radiance * (here * there / square * width * height / (steps * steps));
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

void expect_integral(const World& world, bool mask, double share) {
  for (const glm::dvec3 place :
       {glm::dvec3(0, 0, 1), {-1, 0.3, 0.5}, {1.2, -0.8, 0.7}, {3, 1, 2}}) {
    const Receiver at{place, glm::normalize(glm::dvec3(0.2, 0.1, -1)), {0, 0, -1}};
    const glm::dvec3 expected = integral(world, at, mask), found = by_lights(world, at);
    const double most = std::max({expected.x, expected.y, expected.z});
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], share * most) << place.x << ' ' << c;
  }
}

TEST(TexturedEmitter, TwoHalvesShineFromWhereTheyAre) {
  const Image halves = make_image(2, 1, [](int x, int) {
    return x == 0 ? Texel{255, 0, 0, 255} : Texel{0, 0, 255, 255};
  });
  const World world = emitter(halves, Filter::nearest, false);
  EXPECT_EQ(lights_of_meshes(world).size(), 2u);
  expect_integral(world, false, 1e-3);
}

TEST(TexturedEmitter, AWindowOfFewTexelsShinesAlone) {
  const Image window = make_image(16, 16, [](int x, int y) {
    const bool bright = x >= 10 && x < 13 && y >= 3 && y < 7;
    const bool red = x < 4 && y > 10;
    return Texel{static_cast<std::uint8_t>(bright || red ? 255 : 0),
                 static_cast<std::uint8_t>(bright ? 255 : 0),
                 static_cast<std::uint8_t>(bright ? 255 : 0), 255};
  });
  expect_integral(emitter(window, Filter::nearest, false), false, 5e-3);
}

// One of 16 blocks differs from the gradient by up to a quarter, which matters at distances of half
// its width.
TEST(TexturedEmitter, AGradientIsWithinItsBlocks) {
  const Image ramp = make_image(64, 32, [](int x, int y) {
    return Texel{static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(8 * y),
                 static_cast<std::uint8_t>(255 - 4 * x), 255};
  });
  expect_integral(emitter(ramp, Filter::linear, false), false, 0.05);
}

TEST(TexturedEmitter, MaskedPartsDoNotEmit) {
  const Image holes = make_image(4, 4, [](int x, int y) {
    return Texel{255, 255, 255, static_cast<std::uint8_t>(x == 0 || y == 3 ? 255 : 0)};
  });
  expect_integral(emitter(holes, Filter::nearest, true), true, 5e-3);
}

TEST(TexturedEmitter, AnEvenTextureIsOneLight) {
  const Image even = make_image(8, 8, [](int, int) { return Texel{200, 100, 50, 255}; });
  EXPECT_EQ(lights_of_meshes(emitter(even, Filter::linear, false)).size(), 1u);
}

}  // namespace
}  // namespace asos::test::textured_emitter_test
