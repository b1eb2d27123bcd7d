#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>

namespace asos::test {

inline int add_unlit(Scene& scene, glm::vec3 colour) {
  Material material{.base_color = glm::vec4(colour, 1.0f), .double_sided = true, .unlit = true};
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

inline void add_triangle(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 colour) {
  Mesh mesh{.positions = {a, b, c}};
  mesh.normals.assign(3, glm::normalize(glm::cross(b - a, c - a)));
  mesh.triangles = {{0, 1, 2}};
  mesh.material = add_unlit(scene, colour);
  scene.meshes.push_back(std::move(mesh));
  Instance instance{.mesh = static_cast<int>(scene.meshes.size()) - 1};
  scene.instances.push_back(instance);
}

/// Two unlit triangles, one of this colour in front of a grey one, and a camera at (0, 0, 3) that
/// looks at the origin.
inline Scene two_triangles(glm::vec3 colour, std::string source = "test:two_triangles") {
  Scene scene{.name = "two triangles", .source = std::move(source)};
  add_triangle(scene, {-1, -0.9f, 0}, {0.9f, -0.8f, 0}, {0.1f, 1, 0}, colour);
  add_triangle(scene, {-1.2f, 0.4f, -0.5f}, {1.3f, 0.2f, -0.5f}, {0.3f, 1.4f, -0.5f},
               glm::vec3(0.2f));
  Camera camera{.name = "front"};
  camera.world_from_camera[3] = glm::dvec4(0, 0, 3, 1);
  scene.cameras.push_back(camera);
  return scene;
}

/// Narrow adjacent triangles, several per pixel of a small picture, seen by the same camera.
inline Scene grating(std::string source = "test:grating") {
  Scene scene = two_triangles({1, 0, 0}, std::move(source));
  scene.meshes.clear();
  scene.instances.clear();
  for (int i = -125; i < 125; ++i) {
    const float x = 0.004f * static_cast<float>(i);
    add_triangle(scene, {x, -1, 0}, {x + 0.003f, -1, 0}, {x + 0.001f, 1, 0}, glm::vec3(0.8f));
  }
  return scene;
}

}  // namespace asos::test
