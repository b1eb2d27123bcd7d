#pragma once

#include "renderer/scene/scene.h"

#include <utility>

namespace asos::test {

/// Adds an instance of a mesh with this material; sets its `material`.
inline void place(Scene& scene, Mesh mesh, const Material& material,
                  const glm::dmat4& world_from_mesh = glm::dmat4(1.0)) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  Instance instance{.mesh = static_cast<int>(scene.meshes.size()),
                    .world_from_mesh = world_from_mesh};
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

/// A parallelogram at height z that faces +Z, for -half <= y <= half, between slanted lines that
/// cross y = 0 at x = left and right and shift by `slope` per unit of height.
inline Mesh slanted_strip(double left, double right, double slope, double half, double z) {
  Mesh mesh;
  for (const double y : {-half, half}) {
    for (const double x : {left, right}) mesh.positions.emplace_back(x + slope * y, y, z);
  }
  mesh.normals.assign(4, glm::vec3(0.0f, 0.0f, 1.0f));
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return mesh;
}

/// A wall half a unit in front of the first camera, far larger than its view.
inline void add_wall_before_camera(Scene& scene) {
  Material material{
      .base_color = glm::vec4(glm::vec3(0.7f), 1.0f), .metallic = 0.0f, .double_sided = true};
  place(scene, slanted_strip(-9.0, 9.0, 0.0, 9.0, -0.5), material,
        scene.cameras.front().world_from_camera);
}

}  // namespace asos::test
