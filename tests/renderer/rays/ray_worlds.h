#pragma once

#include "renderer/rays/ray_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// Worlds and rays for tests of ray tracing.

namespace asos::test {

/// Opacity from the material's factors only.
inline float factor_alpha(const World& world, std::uint32_t triangle, float, float) {
  const Material& m = world.material_of(triangle);
  return m.base_color.a * (1.0f - m.transmission);
}

inline RayScene build(const World& world, AlphaAt alpha = factor_alpha,
                      const std::vector<Light>& lights = {}, BvhPurpose use = BvhPurpose::lasting) {
  auto built = RayScene::build(world, alpha, lights, {}, nullptr, use);
  EXPECT_TRUE(built.has_value());
  return std::move(*built);
}

inline glm::vec3 random_point(std::mt19937& rng, float scale) {
  std::uniform_real_distribution<float> d(-scale, scale);
  const float x = d(rng);
  const float y = d(rng);
  return {x, y, d(rng)};
}

inline World random_triangles(std::uint32_t seed, int count, float size) {
  std::mt19937 rng(seed);
  World world;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 c = random_point(rng, 1.0f);
    const glm::vec3 a = c + random_point(rng, size);
    const glm::vec3 b = c + random_point(rng, size);
    add_triangle(world, a, b, c + random_point(rng, size), matte(glm::vec3(0.5f)));
  }
  return world;
}

inline Ray random_ray(std::mt19937& rng) {
  return {.origin = random_point(rng, 2.0f), .direction = random_point(rng, 1.0f)};
}

/// A ray from above z = 0 straight down at (x, y).
inline Ray down(float x, float y, float z = 1.0f) {
  return {.origin = {x, y, z}};
}

/// A square of side 2 around (0, 0, z) whose front faces up (+z) or down.
inline void add_square(World& world, float z, const Material& material, bool faces_up = true) {
  if (faces_up) {
    add_quad(world, {-1, -1, z}, {2, 0, 0}, {0, 2, 0}, material);
  } else {
    add_quad(world, {-1, -1, z}, {0, 2, 0}, {2, 0, 0}, material);
  }
}

inline Material double_sided(Material material) {
  material.double_sided = true;
  return material;
}

inline Material blended(float alpha) {
  Material material = matte(glm::vec3(1));
  material.alpha_mode = AlphaMode::blend;
  material.base_color.a = alpha;
  return material;
}

inline Material masked(float cutoff) {
  Material material = matte(glm::vec3(1));
  material.alpha_mode = AlphaMode::mask;
  material.alpha_cutoff = cutoff;
  return material;
}

/// A light that owns the part.
inline Light lamp_of(std::int32_t part) {
  return {.name = "lamp", .type = Light::Type::rectangle, .own_part = part};
}

}  // namespace asos::test
