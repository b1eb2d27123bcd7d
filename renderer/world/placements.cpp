#include "renderer/world/placements.h"

#include "renderer/geometry/direction.h"
#include "renderer/world/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asos {
namespace {

struct PlacedVertex {
  const Placement& place;
  const World& mesh;
  std::uint32_t vertex;  // of the mesh
};

PlacedVertex find_vertex(const Placements& all, std::uint32_t vertex) {
  const Placement& place = all.places[all.by_vertex.find(vertex)];
  return {place, all.mesh_of(place), vertex - place.first_vertex};
}

glm::vec3 position_of(const Placements& all, const PlacedVertex& v, std::uint32_t vertex) {
  return placed_point(all, v.place, v.mesh.positions.own()[vertex]);
}

// Returns the normal of rounded positions, as for a mesh that is not shared.
glm::vec3 flat_normal(const Placements& all, const PlacedVertex& v) {
  const glm::uvec3 corners = v.mesh.triangles.own()[v.vertex / 3];
  const glm::dvec3 a(position_of(all, v, corners.x));
  const glm::dvec3 b(position_of(all, v, corners.y)), c(position_of(all, v, corners.z));
  const double sign = v.place.mirrored ? -1.0 : 1.0;
  return unit_or(sign * glm::cross(b - a, c - a), glm::vec3(0, 0, 1));
}

glm::vec2 texcoord_of(const Placements& all, int set, std::uint32_t vertex) {
  const PlacedVertex v = find_vertex(all, vertex);
  const std::vector<glm::vec2>& texcoords = v.mesh.texcoords[set].own();
  return texcoords.empty() ? glm::vec2(0.0f) : texcoords[v.vertex];
}

}  // namespace

glm::dmat3 linear_part(const glm::dmat4& matrix) {
  glm::dmat3 linear(matrix);
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(linear[c][r]));
  }
  return largest > 0.0 ? linear * (1.0 / largest) : linear;
}

glm::dmat3 cofactors_of(const glm::dmat3& linear, bool mirrored) {
  const double sign = mirrored ? -1.0 : 1.0;
  return {sign * glm::cross(linear[1], linear[2]), sign * glm::cross(linear[2], linear[0]),
          sign * glm::cross(linear[0], linear[1])};
}

Placement placement_of(const glm::dmat4& world_from_mesh) {
  Placement place;
  const glm::dmat3 linear = linear_part(world_from_mesh);
  place.world_from_mesh = world_from_mesh;
  place.mirrored = glm::determinant(linear) < 0.0;
  place.cofactors = cofactors_of(linear, place.mirrored);
  const Distortion distortion = distortion_of(glm::dmat3(world_from_mesh));
  place.most_growth = distortion.most_growth;
  place.anisotropy = distortion.anisotropy;
  return place;
}

Distortion distortion_of(const glm::dmat3& linear) {
  double squares = 0.0, skew = 0.0;
  const glm::dmat3 products = glm::transpose(linear) * linear;
  for (int k = 0; k < 3; ++k) squares += products[k][k];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      skew = std::max(skew, std::abs(products[i][k] - (i == k ? squares / 3.0 : 0.0)));
  const double growth = std::sqrt(squares);
  constexpr double equal = 1e-9;
  if (skew <= equal * squares) return {growth / std::sqrt(3.0), 1.0};
  // The product of two of the three growths is at most half of the sum of squares.
  const double least = std::abs(glm::determinant(linear)) / (0.5 * squares);
  const bool invertible = least > 0.0 && std::isfinite(growth);
  return {growth, invertible ? growth / least : std::numeric_limits<double>::infinity()};
}

glm::dmat4 Placements::world_from_mesh(const Placement& place) const {
  glm::dmat4 matrix = place.world_from_mesh;
  matrix[3] -= glm::dvec4(origin, 0.0);
  return matrix;
}

std::size_t Placements::memory_bytes() const {
  std::size_t bytes =
      places.capacity() * sizeof(Placement) + by_triangle.memory_bytes() + by_vertex.memory_bytes();
  for (const std::shared_ptr<const World>& mesh : meshes)
    bytes += sizeof(World) + geometry_bytes(*mesh);
  return bytes;
}

glm::vec3 placed_position(const Placements& all, std::uint32_t vertex) {
  const PlacedVertex v = find_vertex(all, vertex);
  return position_of(all, v, v.vertex);
}

glm::vec3 placed_normal(const Placements& all, std::uint32_t vertex) {
  const PlacedVertex v = find_vertex(all, vertex);
  if (v.mesh.flat) return flat_normal(all, v);
  const glm::vec3 n = v.mesh.normals.own()[v.vertex];
  return unit_or(v.place.cofactors * glm::dvec3(n), n);
}

glm::vec4 placed_tangent(const Placements& all, std::uint32_t vertex) {
  const PlacedVertex v = find_vertex(all, vertex);
  if (v.mesh.tangents.own().empty()) return glm::vec4(0.0f);
  const glm::vec4 t = v.mesh.tangents.own()[v.vertex];
  if (glm::vec3(t) == glm::vec3(0.0f)) return glm::vec4(0.0f);
  const glm::vec3 across = any_perpendicular(placed_normal(all, vertex));
  return glm::vec4(unit_or(glm::dmat3(v.place.world_from_mesh) * glm::dvec3(t), across),
                   v.place.mirrored ? -t.w : t.w);
}

glm::vec2 placed_texcoord_0(const Placements& all, std::uint32_t vertex) {
  return texcoord_of(all, 0, vertex);
}

glm::vec2 placed_texcoord_1(const Placements& all, std::uint32_t vertex) {
  return texcoord_of(all, 1, vertex);
}

glm::vec4 placed_color(const Placements& all, std::uint32_t vertex) {
  const PlacedVertex v = find_vertex(all, vertex);
  return v.mesh.colors.own().empty() ? glm::vec4(1.0f) : v.mesh.colors.own()[v.vertex];
}

glm::uvec3 placed_triangle(const Placements& all, std::uint32_t triangle) {
  const Placement& place = all.places[all.by_triangle.find(triangle)];
  glm::uvec3 t = all.mesh_of(place).triangles.own()[triangle - place.first_triangle];
  // Mirroring turns triangles inside out; glTF keeps their front side, so the winding is reversed.
  if (place.mirrored) std::swap(t.y, t.z);
  return t + (all.own_vertices + place.first_vertex);
}

std::uint32_t placed_part(const Placements& all, std::uint32_t triangle) {
  return all.places[all.by_triangle.find(triangle)].part;
}

}  // namespace asos
