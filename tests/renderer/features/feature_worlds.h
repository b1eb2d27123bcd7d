#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <utility>
#include <vector>

// Worlds of a few triangles for tests of features: without bounds, and with attributes only if
// needed.

namespace asos::test {

inline World empty_world(std::size_t materials = 1) {
  World world;
  world.materials.resize(materials);
  return world;
}

// Adds a part of triangles over vertices with one normal each.
inline void add_part(World& world, const std::vector<glm::vec3>& positions,
                     const std::vector<glm::vec3>& normals,
                     const std::vector<glm::uvec3>& triangles, std::uint32_t material = 0) {
  Part part;
  part.first_vertex = static_cast<std::uint32_t>(world.positions.size());
  part.first_triangle = static_cast<std::uint32_t>(world.triangles.size());
  part.vertex_count = static_cast<std::uint32_t>(positions.size());
  part.triangle_count = static_cast<std::uint32_t>(triangles.size());
  part.material = material;
  world.positions.insert(world.positions.end(), positions.begin(), positions.end());
  world.normals.insert(world.normals.end(), normals.begin(), normals.end());
  for (const glm::uvec3& t : triangles) {
    world.triangles.push_back(t + part.first_vertex);
    world.triangle_part.push_back(static_cast<std::uint32_t>(world.parts.size()));
  }
  world.parts.push_back(part);
}

inline const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
inline const std::vector<glm::vec3> up(4, glm::vec3(0, 0, 1));
inline const std::vector<glm::uvec3> two_triangles{{0, 1, 2}, {0, 2, 3}};

// The cube's faces as six separate quads, as exporters write flat shading.
inline World cube(bool smooth) {
  World world = empty_world();
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      for (const auto& [a, b] :
           {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        glm::vec3 p;
        p[axis] = side, p[(axis + 1) % 3] = a, p[(axis + 2) % 3] = b;
        glm::vec3 n(0.0f);
        n[axis] = side;
        positions.push_back(p);
        normals.push_back(smooth ? glm::normalize(p) : n);
      }
      // Counter-clockwise from outside.
      const bool front = side > 0.0f;
      triangles.push_back(first + (front ? glm::uvec3(0, 1, 2) : glm::uvec3(0, 2, 1)));
      triangles.push_back(first + (front ? glm::uvec3(0, 2, 3) : glm::uvec3(0, 3, 2)));
    }
  }
  add_part(world, positions, normals, triangles);
  return world;
}

}  // namespace asos::test
