#pragma once

#include "renderer/scene/scene.h"
#include "tests/support/make_light.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

// Scenes with many instances of meshes, and the same scenes with a copy of the mesh per instance.

namespace asos::test {

/// A unit sphere of 2 * rings * (rings - 1) triangles, smooth or without normals.
inline Mesh ball_mesh(std::uint32_t rings, bool smooth, int material) {
  Mesh mesh{.name = smooth ? "ball" : "gem", .material = material};
  const std::uint32_t sides = rings;
  for (std::uint32_t r = 0; r <= rings; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const double polar = std::numbers::pi * r / rings,
                   around = 2.0 * std::numbers::pi * s / sides;
      const glm::dvec3 p(std::sin(polar) * std::cos(around), std::cos(polar),
                         std::sin(polar) * std::sin(around));
      mesh.positions.emplace_back(p);
      if (smooth) mesh.normals.emplace_back(p);
    }
  }
  for (std::uint32_t r = 0; r < rings; ++r) {
    for (std::uint32_t s = 0; s < sides; ++s) {
      const auto at = [&](std::uint32_t i, std::uint32_t k) { return i * sides + k % sides; };
      if (r + 1 < rings) mesh.triangles.emplace_back(at(r, s), at(r + 1, s + 1), at(r + 1, s));
      if (r > 0) mesh.triangles.emplace_back(at(r, s), at(r, s + 1), at(r + 1, s + 1));
    }
  }
  return mesh;
}

/// A transform with rotation, stretch and, every third time, mirroring; composed like nested nodes.
inline glm::dmat4 place_of(int i, int columns, double spacing) {
  const glm::dvec3 at(spacing * (i % columns - 0.5 * columns), 0.4 + 0.1 * (i % 5),
                      spacing * (i / columns - 0.5 * columns));
  glm::dmat4 outer = glm::translate(glm::dmat4(1.0), at);
  if (i % 3 == 1) outer = glm::scale(outer, glm::dvec3(-1.0, 1.0, 1.0));
  glm::dmat4 inner = glm::rotate(glm::dmat4(1.0), 0.7 * i, glm::dvec3(0.3, 1.0, 0.1 * (i % 7)));
  if (i % 4 == 2) inner = glm::scale(inner, glm::dvec3(1.0, 1.6, 0.7));
  return glm::scale(outer * inner, glm::dvec3(0.4 + 0.05 * (i % 4)));
}

/// `count` instances of two alternating meshes over a floor; some overlap. The second mesh is a
/// mirror. A rectangle lights the scene.
inline Scene instanced_scene(int count, std::uint32_t rings, double spacing = 1.0) {
  Scene scene{.source = "instances"};
  Material matte{.base_color = {0.7f, 0.5f, 0.3f, 1.0f}, .metallic = 0.0f};
  Material mirror{.base_color = {0.8f, 0.9f, 0.9f, 1.0f}, .roughness = 0.0f};
  scene.materials = {matte, mirror};
  scene.meshes = {ball_mesh(rings, true, 0), ball_mesh(rings, false, 1)};
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i)
    scene.instances.push_back({"thing " + std::to_string(i), i % 2, place_of(i, columns, spacing)});
  Mesh floor;
  floor.name = "floor";
  floor.material = 0;
  floor.positions = {{-40, 0, -40}, {40, 0, -40}, {40, 0, 40}, {-40, 0, 40}};
  floor.normals.assign(4, glm::vec3(0, 1, 0));
  floor.triangles = {{0, 2, 1}, {0, 3, 2}};
  scene.meshes.push_back(floor);
  scene.instances.push_back({"floor", 2});
  scene.lights.push_back(make_panel({3, 9, 4}, {0, -1, 0}, {1.5, 0, 0}, {0, 0, 1.5}, 20.0f));
  return scene;
}

/// The same scene with a mesh for each instance, so that nothing is shared.
inline Scene unrolled(Scene scene) {
  std::vector<Mesh> meshes;
  for (Instance& instance : scene.instances) {
    meshes.push_back(scene.meshes[static_cast<std::size_t>(instance.mesh)]);
    instance.mesh = static_cast<int>(meshes.size()) - 1;
  }
  scene.meshes = std::move(meshes);
  return scene;
}

}  // namespace asos::test
