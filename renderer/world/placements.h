#pragma once

#include "renderer/world/range_index.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

// Meshes that a world stores once and shows in many places. Their vertices and triangles have
// numbers in the world, as copies would, and are transformed on access.

namespace asos {

struct World;

/// One place of a shared mesh.
struct Placement {
  std::uint32_t mesh = 0;            ///< index into Placements::meshes
  std::uint32_t part = 0;            ///< index into World::parts
  std::uint32_t first_triangle = 0;  ///< among placed triangles
  std::uint32_t first_vertex = 0;    ///< among placed vertices
  bool mirrored = false;
  glm::dmat4 world_from_mesh{1.0};  ///< in the author's coordinates
  glm::dmat3 cofactors{1.0};        ///< transforms normals, which then have to be normalized
  /// Upper bound on the growth of lengths.
  double most_growth = 1.0;
  /// Upper bound on the ratio of the greatest growth to the least; 1: angles are preserved.
  double anisotropy = 1.0;
};

/// Returns the 3x3 part of a matrix, scaled so that products of its entries neither overflow nor
/// vanish.
[[nodiscard]] glm::dmat3 linear_part(const glm::dmat4& matrix);
/// Returns the inverse transpose times the determinant, which transforms normals. It also exists
/// for singular matrices, where a mesh is squeezed into a plane. Normals of mirrored meshes stay
/// outside.
[[nodiscard]] glm::dmat3 cofactors_of(const glm::dmat3& linear, bool mirrored);
/// Returns a placement with this matrix, without indices.
[[nodiscard]] Placement placement_of(const glm::dmat4& world_from_mesh);

/// The growth and the anisotropy of a matrix; the latter is infinite if the matrix has no inverse.
struct Distortion {
  double most_growth = 1.0;
  double anisotropy = 1.0;
};
[[nodiscard]] Distortion distortion_of(const glm::dmat3& linear);

/// The shared meshes of a world and their places. Immutable, and shared by copies of the world.
struct Placements {
  /// In their own spaces, with one part and one material each.
  std::vector<std::shared_ptr<const World>> meshes;
  std::vector<Placement> places;  ///< in the order of their triangle numbers
  RangeIndex by_triangle, by_vertex;
  std::uint32_t triangle_count = 0;  ///< of all places
  std::uint32_t vertex_count = 0;
  std::uint32_t own_triangles = 0;  ///< number of the world's own triangles, which come first
  std::uint32_t own_vertices = 0;
  glm::dvec3 origin{0.0};  ///< World::origin
  // The attributes of the meshes.
  bool has_tangents = false;
  bool has_texcoords[2] = {false, false};
  bool has_colors = false;

  /// Returns the place of a triangle of the world; `triangle` is at least own_triangles.
  [[nodiscard]] const Placement& of_triangle(std::uint32_t triangle) const {
    return places[index_of_triangle(triangle)];
  }
  [[nodiscard]] std::size_t index_of_triangle(std::uint32_t triangle) const {
    return by_triangle.find(triangle - own_triangles);
  }
  [[nodiscard]] const World& mesh_of(const Placement& place) const { return *meshes[place.mesh]; }
  /// Returns the matrix to the world's coordinates, which are relative to its origin.
  [[nodiscard]] glm::dmat4 world_from_mesh(const Placement& place) const;
  [[nodiscard]] std::size_t memory_bytes() const;
};

/// Returns a point of a mesh in the world, rounded as World::positions are.
[[nodiscard]] inline glm::vec3 placed_point(const Placements& all, const Placement& place,
                                            glm::vec3 of_mesh) {
  return glm::vec3(glm::dvec3(place.world_from_mesh * glm::dvec4(of_mesh, 1.0)) - all.origin);
}

// Values of placed vertices and triangles, numbered from the first placed one.
[[nodiscard]] glm::vec3 placed_position(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::vec3 placed_normal(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::vec4 placed_tangent(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::vec2 placed_texcoord_0(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::vec2 placed_texcoord_1(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::vec4 placed_color(const Placements& all, std::uint32_t vertex);
[[nodiscard]] glm::uvec3 placed_triangle(const Placements& all, std::uint32_t triangle);
[[nodiscard]] std::uint32_t placed_part(const Placements& all, std::uint32_t triangle);

}  // namespace asos
