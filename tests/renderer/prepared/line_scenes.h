#pragma once

#include "renderer/prepared/with_lines.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/quad_mesh.h"
#include "tests/support/render_picture.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

// Scenes of lines and points, and pictures of them.

namespace asos::test::line_scenes {

inline constexpr float red = 0.9f;

inline Material red_material() {
  return {.base_color = {red, 0.0f, 0.0f, 1.0f}};
}

inline Mesh lines(std::vector<glm::vec3> positions) {
  Mesh mesh{.positions = std::move(positions)};
  for (std::uint32_t i = 0; i + 1 < mesh.positions.size(); i += 2)
    mesh.segments.emplace_back(i, i + 1);
  mesh.material = 0;
  return mesh;
}

inline Mesh points(std::vector<glm::vec3> positions) {
  Mesh mesh{.positions = std::move(positions)};
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.points.push_back(i);
  mesh.material = 0;
  return mesh;
}

/// A plain square in the plane z = `z`, from -half to half, facing +Z.
inline Mesh square(float half, float z) {
  Mesh mesh{.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}};
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

inline Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene{.source = "test"};
  scene.materials.push_back(red_material());
  for (Mesh& mesh : meshes) {
    add_object(scene, std::move(mesh), "it");
  }
  scene.lights.push_back(make_sun(glm::normalize(glm::dvec3(0.3, -0.2, -1.0))));
  return scene;
}

/// At (0, 0, 5) in the author's coordinates, looking along -Z.
inline Camera camera_for(const RenderScene& scene, bool perspective = true) {
  Camera camera{.type = perspective ? Camera::Type::perspective : Camera::Type::orthographic,
                .fov_y_rad = 0.7,
                .height = 4.0};
  camera.world_from_camera[3] = glm::dvec4(glm::dvec3(0, 0, 5) - scene.world().origin, 1.0);
  return camera;
}

inline RenderSettings settings_of(double line_width) {
  RenderSettings settings = make_settings(64, 48);
  settings.line_width = line_width;
  settings.asos.max_level = 5;
  return settings;
}

inline std::shared_ptr<const RenderScene> prepared(const Scene& scene) {
  return prepare(scene).value();
}

inline Film picture_of(const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
                       const RenderSettings& settings) {
  const auto drawn = with_lines(scene, line_picture(camera, settings)).value();
  return render_picture(*drawn, camera, settings).film;
}

inline glm::vec3 at(const Film& film, int x, int y) {
  return film.radiance[film.index(x, y)];
}

}  // namespace asos::test::line_scenes
