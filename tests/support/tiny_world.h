#pragma once

#include "renderer/world/world.h"
#include "tests/support/make_light.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

// Worlds of a few triangles built by hand. Every vertex has a normal and texture coordinates (set
// 0), so that any material can be used.

namespace asos::test {

struct TinyVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
};

/// Adds one part; returns its index.
inline std::uint32_t add_part(World& world, const std::vector<TinyVertex>& vertices,
                              const std::vector<glm::uvec3>& triangles, const Material& material) {
  Part part{.first_triangle = static_cast<std::uint32_t>(world.triangles.size()),
            .triangle_count = static_cast<std::uint32_t>(triangles.size()),
            .first_vertex = static_cast<std::uint32_t>(world.positions.size()),
            .vertex_count = static_cast<std::uint32_t>(vertices.size()),
            .material = static_cast<std::uint32_t>(world.materials.size())};
  world.materials.push_back(material);
  for (const TinyVertex& v : vertices) {
    world.positions.push_back(v.position);
    world.normals.push_back(v.normal);
    world.texcoords[0].push_back(v.uv);
  }
  const auto index = static_cast<std::uint32_t>(world.parts.size());
  for (const glm::uvec3& t : triangles) {
    for (int k = 0; k < 3; ++k) part.bounds.grow(vertices[t[k]].position);
    world.triangles.push_back(t + part.first_vertex);
    world.triangle_part.push_back(index);
    for (int k = 0; k < 3; ++k) world.bounds.grow(vertices[t[k]].position);
  }
  world.parts.push_back(part);
  return index;
}

inline void add_triangle(World& world, glm::vec3 a, glm::vec3 b, glm::vec3 c,
                         const Material& material) {
  const glm::vec3 cross = glm::cross(b - a, c - a);
  const float length = glm::length(cross);
  const glm::vec3 n = length > 0.0f ? cross / length : glm::vec3(0, 0, 1);
  add_part(world, {{a, n, {0, 0}}, {b, n, {1, 0}}, {c, n, {0, 1}}}, {{0, 1, 2}}, material);
}

/// The parallelogram corner, corner + a, corner + a + b, corner + b; uv goes from (0, 0) along a
/// and b; the normal is a x b.
inline void add_quad(World& world, glm::vec3 corner, glm::vec3 a, glm::vec3 b,
                     const Material& material) {
  const glm::vec3 n = glm::normalize(glm::cross(a, b));
  add_part(world,
           {{corner, n, {0, 0}},
            {corner + a, n, {1, 0}},
            {corner + a + b, n, {1, 1}},
            {corner + b, n, {0, 1}}},
           {{0, 1, 2}, {0, 2, 3}}, material);
}

/// A sphere of `rings` by twice as many segments, with smooth normals.
inline void add_sphere(World& world, glm::vec3 centre, float radius, int rings,
                       const Material& material) {
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  const int segments = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= segments; ++j) {
      const float v = static_cast<float>(i) / static_cast<float>(rings);
      const float u = static_cast<float>(j) / static_cast<float>(segments);
      const float theta = v * std::numbers::pi_v<float>;
      const float phi = 2.0f * u * std::numbers::pi_v<float>;
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                        -std::sin(theta) * std::sin(phi));
      vertices.push_back({centre + radius * n, n, {u, v}});
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      const auto a = static_cast<std::uint32_t>(i * (segments + 1) + j);
      const auto c = a + static_cast<std::uint32_t>(segments) + 1u;
      if (i > 0) triangles.emplace_back(a, c, a + 1);
      if (i + 1 < rings) triangles.emplace_back(a + 1, c, c + 1);
    }
  }
  add_part(world, vertices, triangles, material);
}

inline Material matte(glm::vec3 color) {
  return {.base_color = glm::vec4(color, 1.0f), .metallic = 0.0f, .roughness = 1.0f};
}

inline Material unlit(glm::vec3 color, float alpha = 1.0f) {
  Material m{.base_color = glm::vec4(color, alpha), .unlit = true};
  if (alpha < 1.0f) m.alpha_mode = AlphaMode::blend;
  return m;
}

inline int add_texture(World& world, Image image, Wrap wrap, Filter filter) {
  Texture texture{.image = static_cast<int>(world.images.size())};
  texture.wrap_u = texture.wrap_v = wrap;
  texture.filter = filter;
  world.images.push_back(std::move(image));
  world.textures.push_back(texture);
  return static_cast<int>(world.textures.size()) - 1;
}

/// Changes the alpha of a finished world's vertices by a tiny amount, which does not affect a
/// cutoff of 1/2 for alphas 0 and 1. Outlines of its cut-outs are then unknown and left to samples.
inline void leave_cut_outs_to_samples(World& world) {
  world.colors.assign(world.positions.size(), glm::vec4(1.0f));
  for (std::size_t i = 0; i < world.colors.size(); i += 2) world.colors[i].a = 0.9f;
}

/// Looks from `eye` at `target`, +Y up.
inline Camera look_at(glm::dvec3 eye, glm::dvec3 target, double fov_y_rad) {
  const glm::dvec3 back = glm::normalize(eye - target);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
  Camera camera{.fov_y_rad = fov_y_rad};
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
                 glm::dvec4(eye, 1));
  return camera;
}

/// Looks along -Z at the rectangle |x| <= height / 2 * aspect, |y| <= height / 2.
inline Camera orthographic(double height) {
  Camera camera{.type = Camera::Type::orthographic, .height = height};
  camera.world_from_camera[3] = glm::dvec4(0, 0, 10, 1);
  return camera;
}

/// A floor, a sphere and a thin post under one light: edges, a shadow, smooth shading.
inline FlattenedScene still_life() {
  FlattenedScene scene;
  World& world = scene.world;
  add_quad(world, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, matte({0.7f, 0.7f, 0.6f}));
  add_sphere(world, {0.4f, 0.8f, 0}, 0.8f, 12, matte({0.8f, 0.2f, 0.1f}));
  add_quad(world, {-1.2f, 0, 0.5f}, {0.05f, 0, 0}, {0, 2, 0}, matte({0.1f, 0.3f, 0.8f}));
  scene.lights.push_back(make_sun(glm::normalize(glm::dvec3(-0.4, -1.0, -0.3)), 2.0f));
  return scene;
}

}  // namespace asos::test
