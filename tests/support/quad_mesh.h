#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>

namespace asos::test {

/// A flat parallelogram with the sides `a` and `b` from a corner; it faces along cross(a, b).
inline Mesh quad_mesh(glm::vec3 corner, glm::vec3 a, glm::vec3 b, int material = 0) {
  Mesh mesh{.positions = {corner, corner + a, corner + a + b, corner + b},
            .triangles = {{0, 1, 2}, {0, 2, 3}},
            .material = material};
  mesh.normals.assign(4, glm::normalize(glm::cross(a, b)));
  return mesh;
}

/// Adds a mesh as an object of the scene.
inline void add_object(Scene& scene, Mesh mesh, const std::string& name = "",
                       const glm::dmat4& world_from_mesh = glm::dmat4(1.0)) {
  scene.instances.push_back({name, static_cast<int>(scene.meshes.size()), world_from_mesh});
  scene.meshes.push_back(std::move(mesh));
}

/// The same with a material of its own.
inline void add_object(Scene& scene, Mesh mesh, const Material& material,
                       const std::string& name = "",
                       const glm::dmat4& world_from_mesh = glm::dmat4(1.0)) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  add_object(scene, std::move(mesh), name, world_from_mesh);
}

}  // namespace asos::test
