#include "renderer/scene/builtin/tools.h"

#include "renderer/scene/builtin/scene_assembler.h"
#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asos::builtin {

namespace {

/// The nail that a tool hangs on.
void add_nail(ToolMeshes& tools, glm::vec3 at) {
  add_frustum(tools.rods, {at.x, at.y, 0.02f}, {at.x, at.y, at.z + 0.02f}, 0.004f, 0.004f, 8);
}

glm::vec3 below(glm::vec3 at, float distance) {
  return at - glm::vec3(0.0f, distance, 0.0f);
}

/// A flat ring around an axis along z.
void add_eye(Mesh& mesh, glm::vec3 centre, float outer, float inner, float depth) {
  const std::array<glm::vec2, 5> outline{{{inner, -0.5f * depth},
                                          {outer, -0.5f * depth},
                                          {outer, 0.5f * depth},
                                          {inner, 0.5f * depth},
                                          {inner, -0.5f * depth}}};
  add_lathe(mesh, centre, {0.0f, 0.0f, 1.0f}, outline, 20);
}

glm::mat4 tilted(glm::vec3 at, float degrees) {
  return glm::rotate(glm::translate(glm::mat4(1.0f), at), glm::radians(degrees),
                     glm::vec3(0.0f, 0.0f, 1.0f));
}

}  // namespace

void add_spanner(ToolMeshes& tools, glm::vec3 at, float length) {
  const float head = 0.085f * length;
  add_nail(tools, at);
  add_eye(tools.blades, at, head, 0.6f * head, 0.3f * head);
  add_beam(tools.blades, below(at, 0.85f * head), below(at, length - 1.4f * head), 0.75f * head,
           0.16f * head, {0.0f, 0.0f, 1.0f});
  // The open end: a block with two jaws.
  const glm::vec3 end = below(at, length - head);
  add_box(tools.blades, {1.9f * head, 0.9f * head, 0.3f * head}, tilted(end, 15.0f));
  for (const float side : {-1.0f, 1.0f})
    add_box(tools.blades, {0.55f * head, 1.1f * head, 0.28f * head},
            tilted(end, 15.0f) *
                glm::translate(glm::mat4(1.0f), {0.66f * side * head, -0.95f * head, 0.0f}));
}

void add_screwdriver(ToolMeshes& tools, glm::vec3 at, float length) {
  const float handle = 0.42f * length, radius = 0.05f * length;
  const std::array<glm::vec2, 8> outline{{{0.0f, 0.0f},
                                          {0.55f * radius, 0.0f},
                                          {0.7f * radius, 0.1f * handle},
                                          {0.62f * radius, 0.2f * handle},
                                          {radius, 0.4f * handle},
                                          {radius, 0.85f * handle},
                                          {0.7f * radius, handle},
                                          {0.0f, handle}}};
  add_lathe(tools.handles, below(at, handle), {0.0f, 1.0f, 0.0f}, outline, 14);
  add_frustum(tools.rods, below(at, length), below(at, handle - 0.01f), 0.2f * radius,
              0.22f * radius, 10);
  add_box(tools.rods, {at.x - 0.4f * radius, at.y - length - 0.012f, at.z - 0.08f * radius},
          {at.x + 0.4f * radius, at.y - length + 0.01f, at.z + 0.08f * radius});
  for (const float side : {-1.25f, 1.25f})
    add_frustum(tools.rods, {at.x + side * radius, at.y - 0.5f * handle, 0.02f},
                {at.x + side * radius, at.y - 0.5f * handle, at.z + radius}, 0.0025f, 0.0025f, 6);
}

void add_hammer(ToolMeshes& tools, glm::vec3 at, float length) {
  const float head = 0.17f * length, half = 0.075f * length;
  add_frustum(tools.wood, below(at, length), below(at, -0.01f), 0.05f * length, 0.036f * length,
              14);
  add_box(tools.blades, {at.x - 0.9f * half, at.y - 1.7f * half, at.z - 0.8f * half},
          {at.x + 0.9f * half, at.y - 0.05f * half, at.z + 0.8f * half});
  const glm::vec3 middle = below(at, 0.9f * half), along(1.0f, 0.0f, 0.0f);
  add_frustum(tools.rods, middle + 0.8f * half * along, middle + head * along, 0.62f * half,
              0.62f * half, 18);
  add_frustum(tools.rods, middle + head * along, middle + 1.25f * head * along, 0.8f * half,
              0.78f * half, 18);
  const std::array<glm::vec2, 4> peen{{{0.0f, -0.6f * half},
                                       {0.0f, 0.6f * half},
                                       {-1.1f * head, 0.12f * half},
                                       {-1.1f * head, -0.12f * half}}};
  add_prism(tools.blades, peen, half,
            glm::translate(glm::mat4(1.0f), middle - glm::vec3(0.7f * half, 0.0f, 0.5f * half)));
  for (const float side : {-1.0f, 1.0f})
    add_nail(tools, {at.x + 1.3f * side * half, at.y - 2.0f * half, at.z});
}

void add_saw(ToolMeshes& tools, glm::vec3 at, float length) {
  const float width = 0.2f * length;
  // The blade hangs from its handle and narrows downwards.
  const std::array<glm::vec2, 4> blade{
      {{0.0f, 0.0f}, {0.2f * width, -length}, {0.6f * width, -length}, {width, 0.0f}}};
  add_prism(tools.blades, blade, 0.0022f, glm::translate(glm::mat4(1.0f), at));
  const glm::mat4 grip =
      glm::translate(glm::mat4(1.0f), at + glm::vec3(0.5f * width, 0.05f, -0.008f));
  add_frame(tools.wood, {0.42f * width, 0.075f}, {0.22f * width, 0.045f}, 0.02f, grip);
  for (const float x : {0.3f, 0.7f})
    add_frustum(tools.rods, at + glm::vec3(x * width, -0.012f, -0.004f),
                at + glm::vec3(x * width, -0.012f, 0.014f), 0.006f, 0.006f, 12);
  add_nail(tools, {at.x + 0.5f * width, at.y + 0.086f, at.z});
}

void add_square(ToolMeshes& tools, glm::vec3 at, float length) {
  add_box(tools.wood, {at.x - 0.5f * length, at.y - 0.04f, at.z - 0.012f},
          {at.x, at.y, at.z + 0.012f});
  add_box(tools.blades, {at.x - 0.036f, at.y - length, at.z - 0.0015f},
          {at.x - 0.002f, at.y - 0.006f, at.z + 0.0015f});
  for (const float x : {0.4f, 0.12f})
    add_frustum(tools.rods, {at.x - x * length, at.y - 0.044f, 0.02f},
                {at.x - x * length, at.y - 0.044f, at.z + 0.02f}, 0.004f, 0.004f, 8);
}

void add_pliers(ToolMeshes& tools, glm::vec3 at, float length) {
  const glm::vec3 pivot = below(at, 0.3f * length);
  add_frustum(tools.rods, pivot - glm::vec3(0.0f, 0.0f, 0.012f),
              pivot + glm::vec3(0.0f, 0.0f, 0.014f), 0.05f * length, 0.05f * length, 16);
  for (const float side : {-1.0f, 1.0f}) {
    const float depth = 0.003f * side;
    const glm::vec3 jaw = pivot + glm::vec3(0.012f * side * length / 0.25f, 0.28f * length, depth);
    add_beam(tools.blades, pivot + glm::vec3(-0.02f * side, -0.01f, depth), jaw, 0.07f * length,
             0.012f, {0.0f, 0.0f, 1.0f});
    std::vector<glm::vec3> arm;
    for (int i = 0; i <= 8; ++i) {
      const float t = static_cast<float>(i) / 8.0f;
      const float out = 0.05f + 0.13f * std::sin(0.75f * glm::pi<float>() * t);
      arm.push_back(pivot + glm::vec3(side * length * out * (0.3f + 0.7f * t),
                                      -length * (0.02f + 0.66f * t), depth));
    }
    add_tube(tools.handles, arm, 0.026f * length, 10);
  }
  add_nail(tools, below(at, 0.42f * length));
}

void add_chisel(ToolMeshes& tools, glm::vec3 at, float length) {
  const float handle = 0.48f * length, radius = 0.055f * length;
  const std::array<glm::vec2, 7> outline{{{0.0f, 0.0f},
                                          {0.6f * radius, 0.0f},
                                          {0.9f * radius, 0.35f * handle},
                                          {0.75f * radius, 0.7f * handle},
                                          {radius, 0.95f * handle},
                                          {0.8f * radius, handle},
                                          {0.0f, handle}}};
  add_lathe(tools.wood, below(at, handle), {0.0f, 1.0f, 0.0f}, outline, 14);
  add_beam(tools.blades, below(at, handle - 0.01f), below(at, length), 0.07f * length,
           0.014f * length, {0.0f, 0.0f, 1.0f});
  for (const float side : {-1.3f, 1.3f})
    add_frustum(tools.rods, {at.x + side * radius, at.y - 0.6f * handle, 0.02f},
                {at.x + side * radius, at.y - 0.6f * handle, at.z + radius}, 0.0025f, 0.0025f, 6);
}

void add_vice(ToolMeshes& tools, glm::vec3 foot) {
  const auto box = [&](Mesh& mesh, glm::vec3 lo, glm::vec3 hi) {
    add_box(mesh, foot + lo, foot + hi);
  };
  add_frustum(tools.cast, foot, foot + glm::vec3(0.0f, 0.05f, 0.0f), 0.13f, 0.1f, 24);
  box(tools.cast, {-0.06f, 0.04f, -0.12f}, {0.06f, 0.13f, 0.06f});
  box(tools.cast, {-0.09f, 0.06f, -0.05f}, {0.09f, 0.21f, 0.0f});
  box(tools.cast, {-0.09f, 0.06f, 0.07f}, {0.09f, 0.21f, 0.12f});
  box(tools.cast, {-0.045f, 0.065f, -0.02f}, {0.045f, 0.115f, 0.2f});
  box(tools.blades, {-0.088f, 0.175f, -0.001f}, {0.088f, 0.217f, 0.012f});
  box(tools.blades, {-0.088f, 0.175f, 0.058f}, {0.088f, 0.217f, 0.071f});
  add_frustum(tools.rods, foot + glm::vec3(0.0f, 0.09f, 0.19f),
              foot + glm::vec3(0.0f, 0.09f, 0.26f), 0.022f, 0.022f, 16);
  add_frustum(tools.rods, foot + glm::vec3(-0.1f, 0.03f, 0.24f),
              foot + glm::vec3(0.1f, 0.15f, 0.24f), 0.007f, 0.007f, 10);
  for (const auto& [x, y] : {std::array{-0.1f, 0.03f}, {0.1f, 0.15f}})
    add_sphere(tools.rods, foot + glm::vec3(x, y, 0.24f), 0.013f, 4);
}

void add_vessel(Mesh& mesh, glm::vec3 foot, float size, bool tall) {
  // The outside from the foot up, over the rim, and down the inside.
  std::vector<glm::vec2> outside;
  constexpr int steps = 14;
  for (int i = 0; i <= steps; ++i) {
    const float t = static_cast<float>(i) / steps;
    const float radius =
        tall ? 0.55f + 0.45f * std::sin(glm::pi<float>() * (0.05f + 0.95f * t)) - 0.15f * t
             : 0.3f + 0.7f * std::sin(0.5f * glm::pi<float>() * t);
    const float height = tall ? 2.3f * t : 0.75f * (1.0f - std::cos(0.45f * glm::pi<float>() * t));
    outside.push_back(size * glm::vec2(radius, height));
  }
  std::vector<glm::vec2> outline{{0.0f, 0.0f}};
  outline.insert(outline.end(), outside.begin(), outside.end());
  const float wall = 0.03f * size;
  for (std::size_t i = outside.size(); i-- > 0;) {
    const glm::vec2 inside = outside[i] + glm::vec2(-wall, i == 0 ? wall : 0.35f * wall);
    outline.push_back(inside);
  }
  outline.push_back({0.0f, wall});
  add_lathe(mesh, foot, {0.0f, 1.0f, 0.0f}, outline, 64);
}

void add_gear(Mesh& mesh, glm::vec3 centre, float radius, int teeth) {
  const float height = 0.04f, root = 0.86f * radius, bore = 0.25f * radius;
  const std::array<glm::vec2, 9> outline{{{bore, 0.0f},
                                          {root, 0.0f},
                                          {root, height},
                                          {0.78f * radius, height},
                                          {0.74f * radius, 0.6f * height},
                                          {0.45f * radius, 0.6f * height},
                                          {0.42f * radius, height},
                                          {bore, height},
                                          {bore, 0.0f}}};
  add_lathe(mesh, centre, {0.0f, 1.0f, 0.0f}, outline, 2 * teeth);
  const float half = 0.22f * glm::two_pi<float>() * radius / static_cast<float>(teeth);
  const std::array<glm::vec2, 4> tooth{
      {{0.9f * root, -half}, {radius, -0.6f * half}, {radius, 0.6f * half}, {0.9f * root, half}}};
  for (int i = 0; i < teeth; ++i) {
    const float angle = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(teeth);
    // The outline's plane becomes horizontal: its z becomes up.
    glm::mat4 place(1.0f);
    place[0] = {std::cos(angle), 0.0f, -std::sin(angle), 0.0f};
    place[1] = {-std::sin(angle), 0.0f, -std::cos(angle), 0.0f};
    place[2] = {0.0f, 1.0f, 0.0f, 0.0f};
    place[3] = glm::vec4(centre + glm::vec3(0.0f, 0.001f, 0.0f), 1.0f);
    add_prism(mesh, tooth, height - 0.002f, place);
  }
}

void add_round_texcoords(Mesh& mesh, std::uint32_t first, glm::vec3 base, glm::vec3 axis,
                         float radius) {
  const glm::vec3 up = glm::normalize(axis);
  const glm::vec3 aside =
      std::abs(up.y) > 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  const glm::vec3 x = glm::normalize(glm::cross(aside, up)), z = glm::cross(up, x);
  const float around = glm::two_pi<float>() * radius;
  const auto flat_end = [&](std::uint32_t i) {
    return std::abs(glm::dot(mesh.normals[i], up)) > 0.9f;
  };
  mesh.texcoords[0].resize(mesh.positions.size());
  for (std::uint32_t i = first; i < vertex_count(mesh); ++i) {
    const glm::vec3 p = mesh.positions[i] - base;
    const float out_x = glm::dot(p, x), out_z = glm::dot(p, z);
    const float turn = std::atan2(out_z, out_x) / glm::two_pi<float>() + 0.5f;
    // The sum of the horizontal and the axial distance, which grows along the outline.
    const float down = glm::dot(p, up) + std::sqrt(out_x * out_x + out_z * out_z);
    mesh.texcoords[0][i] = flat_end(i) ? glm::vec2(out_x, out_z) : glm::vec2(turn * around, -down);
  }
  // Triangles across the seam get copies of their vertices with small u, one turn further.
  for (glm::uvec3& t : mesh.triangles) {
    if (t.x < first || flat_end(t.x)) continue;
    const auto u = [&](std::uint32_t i) { return mesh.texcoords[0][i].x; };
    const float most = std::max({u(t.x), u(t.y), u(t.z)});
    for (int k = 0; k < 3; ++k) {
      if (most - u(t[k]) < 0.5f * around) continue;
      const std::uint32_t twin = vertex_count(mesh);
      mesh.positions.push_back(glm::vec3(mesh.positions[t[k]]));
      mesh.normals.push_back(glm::vec3(mesh.normals[t[k]]));
      mesh.texcoords[0].push_back(mesh.texcoords[0][t[k]] + glm::vec2(around, 0.0f));
      t[k] = twin;
    }
  }
}

}  // namespace asos::builtin
