#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// The parts of a scene's meshes that become part of its World.

namespace asos {

/// The vertices and triangles of a mesh that become part of the world.
struct PlacedMesh {
  const Mesh* mesh = nullptr;
  bool flat = false;                      ///< no normals: each triangle has its own vertices
  std::vector<std::uint32_t> source;      ///< world vertex -> mesh vertex; empty: the same
  std::vector<glm::uvec3> own_triangles;  ///< where `source` is not empty
  [[nodiscard]] const std::vector<glm::uvec3>& triangles() const {
    return source.empty() ? mesh->triangles : own_triangles;
  }
  [[nodiscard]] std::size_t vertex_count() const {
    return source.empty() ? mesh->positions.size() : source.size();
  }
  [[nodiscard]] std::size_t vertex(std::size_t i) const { return source.empty() ? i : source[i]; }
};

/// Omits unused vertices, since they may lie anywhere.
[[nodiscard]] PlacedMesh place(const Mesh& mesh);

/// Returns whether a vertex of a mesh has another colour than white.
[[nodiscard]] bool is_coloured(const Mesh& mesh);

/// The vertex attributes that the world stores.
struct Attributes {
  bool tangents = false;
  bool texcoords[2] = {false, false};
  bool colors = false;
};
/// Returns the attributes that the visible meshes need; `shown` has one flag per mesh.
[[nodiscard]] Attributes find_attributes(const Scene& scene, const std::vector<bool>& shown);

}  // namespace asos
