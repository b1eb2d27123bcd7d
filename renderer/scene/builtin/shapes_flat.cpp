#include "renderer/scene/builtin/shapes.h"

#include <array>
#include <cassert>

namespace asos::builtin {

namespace {

/// A planar convex polygon, flat-shaded, as a fan from its first corner.
void add_polygon(Mesh& mesh, std::span<const glm::vec3> corners) {
  assert(corners.size() >= 3);
  // Newell's sum is precise enough for long thin faces, unlike a single cross product.
  glm::dvec3 twice_area(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a(corners[i] - corners[0]);
    const glm::dvec3 b(corners[(i + 1) % corners.size()] - corners[0]);
    twice_area += glm::cross(a, b);
  }
  const glm::vec3 normal(glm::normalize(twice_area));
  const std::uint32_t first = vertex_count(mesh);
  for (const glm::vec3& corner : corners) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) {
    mesh.triangles.emplace_back(first, first + i - 1, first + i);
  }
}

/// The hexahedron whose corners are numbered by bits: 1 for +x, 2 for +y, 4 for +z.
void add_hexahedron(Mesh& mesh, const std::array<glm::vec3, 8>& corner) {
  constexpr std::array<std::array<int, 4>, 6> faces{{
      {0, 4, 6, 2},  // -x
      {1, 3, 7, 5},  // +x
      {0, 1, 5, 4},  // -y
      {2, 6, 7, 3},  // +y
      {0, 2, 3, 1},  // -z
      {4, 5, 7, 6},  // +z
  }};
  for (const auto& f : faces) {
    const std::array<glm::vec3, 4> face{corner[f[0]], corner[f[1]], corner[f[2]], corner[f[3]]};
    add_polygon(mesh, face);
  }
}

}  // namespace

void add_quad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
  add_polygon(mesh, std::array<glm::vec3, 4>{a, b, c, d});
}

void add_rim(Mesh& mesh, std::span<const glm::vec3, 4> outer, std::span<const glm::vec3, 4> inner) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    add_quad(mesh, outer[i], outer[next], inner[next], inner[i]);
  }
}

void add_texcoords(Mesh& mesh) {
  mesh.texcoords[0].clear();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 normal = mesh.normals[i];
    const glm::vec3 level = glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), normal);
    const glm::vec3 along =
        glm::length(level) > 1e-3f ? glm::normalize(level) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 down = glm::cross(along, normal);
    mesh.texcoords[0].emplace_back(glm::dot(mesh.positions[i], along),
                                   glm::dot(mesh.positions[i], down));
  }
}

void add_box(Mesh& mesh, glm::vec3 lo, glm::vec3 hi) {
  std::array<glm::vec3, 8> corner;
  for (int i = 0; i < 8; ++i) {
    corner[i] = {(i & 1) ? hi.x : lo.x, (i & 2) ? hi.y : lo.y, (i & 4) ? hi.z : lo.z};
  }
  add_hexahedron(mesh, corner);
}

void add_box(Mesh& mesh, glm::vec3 size, const glm::mat4& placement) {
  std::array<glm::vec3, 8> corner;
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 side((i & 1) ? 0.5f : -0.5f, (i & 2) ? 0.5f : -0.5f, (i & 4) ? 0.5f : -0.5f);
    corner[i] = glm::vec3(placement * glm::vec4(side * size, 1.0f));
  }
  add_hexahedron(mesh, corner);
}

void add_beam(Mesh& mesh, glm::vec3 from, glm::vec3 to, float width, float height, glm::vec3 up) {
  const glm::vec3 along = glm::normalize(to - from);
  const glm::vec3 across = glm::normalize(glm::cross(up, along));
  const glm::vec3 x = across * (0.5f * width);
  const glm::vec3 y = glm::cross(along, across) * (0.5f * height);
  std::array<glm::vec3, 8> corner;
  for (int i = 0; i < 8; ++i) {
    corner[i] = ((i & 4) ? to : from) + ((i & 1) ? x : -x) + ((i & 2) ? y : -y);
  }
  add_hexahedron(mesh, corner);
}

void add_extrusion(Mesh& mesh, std::span<const glm::vec2> outline, std::span<const glm::uvec3> cap,
                   float depth, const glm::mat4& placement) {
  std::vector<glm::vec3> back, front;
  for (const glm::vec2& p : outline) {
    back.emplace_back(placement * glm::vec4(p, 0.0f, 1.0f));
    front.emplace_back(placement * glm::vec4(p, depth, 1.0f));
  }
  const auto add_cap = [&](const std::vector<glm::vec3>& corners, glm::vec3 outwards, bool flip) {
    const glm::vec3 normal = glm::normalize(glm::mat3(placement) * outwards);
    const std::uint32_t first = vertex_count(mesh);
    for (const glm::vec3& corner : corners) {
      mesh.positions.push_back(corner);
      mesh.normals.push_back(normal);
    }
    for (const glm::uvec3& t : cap) {
      mesh.triangles.push_back(first + (flip ? glm::uvec3(t.x, t.z, t.y) : t));
    }
  };
  add_cap(front, {0.0f, 0.0f, 1.0f}, false);
  add_cap(back, {0.0f, 0.0f, -1.0f}, true);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    add_quad(mesh, back[i], back[next], front[next], front[i]);
  }
}

void add_prism(Mesh& mesh, std::span<const glm::vec2> outline, float depth,
               const glm::mat4& placement) {
  std::vector<glm::uvec3> fan;
  for (std::uint32_t i = 2; i < outline.size(); ++i) fan.emplace_back(0u, i - 1, i);
  add_extrusion(mesh, outline, fan, depth, placement);
}

void add_frame(Mesh& mesh, glm::vec2 outer, glm::vec2 inner, float depth,
               const glm::mat4& placement) {
  const auto ring = [&placement](glm::vec2 half, float z) {
    std::array<glm::vec3, 4> corners{
        {{-half, z}, {half.x, -half.y, z}, {half, z}, {-half.x, half.y, z}}};
    for (glm::vec3& corner : corners) corner = glm::vec3(placement * glm::vec4(corner, 1.0f));
    return corners;
  };
  const std::array<glm::vec3, 4> back_outer = ring(outer, 0.0f), back_inner = ring(inner, 0.0f);
  const std::array<glm::vec3, 4> front_outer = ring(outer, depth), front_inner = ring(inner, depth);
  add_rim(mesh, front_outer, front_inner);
  add_rim(mesh, back_inner, back_outer);
  add_rim(mesh, back_outer, front_outer);
  add_rim(mesh, front_inner, back_inner);
}

}  // namespace asos::builtin
