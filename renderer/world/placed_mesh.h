#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

// The parts of a scene's meshes that go into its World.

namespace asos {

/// Which of a mesh's vertices go into the world, and as what triangles.
struct PlacedMesh {
  const Mesh* mesh = nullptr;
  bool flat = false;                      ///< no normals: each triangle has vertices of its own
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

/// Leaves out the vertices that no triangle uses, since they may lie anywhere.
[[nodiscard]] PlacedMesh place(const Mesh& mesh);

/// Whether a vertex of a mesh has another colour than white.
[[nodiscard]] bool is_coloured(const Mesh& mesh);

/// The attributes that the world keeps.
struct Attributes {
  bool tangents = false;
  bool texcoords[2] = {false, false};
  bool colors = false;
};
/// Those that the shown meshes need; one flag a mesh.
[[nodiscard]] Attributes find_attributes(const Scene& scene, const std::vector<bool>& shown);

}  // namespace asos
