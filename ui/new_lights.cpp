#include "ui/new_lights.h"

#include "renderer/lights/emitters.h"
#include "ui/edited_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

glm::dvec3 corner_of(const World& world, std::uint32_t triangle, int k) {
  return glm::dvec3(world.positions[world.triangles[triangle][k]]);
}

/// Unit normal; zero for a triangle without area.
glm::dvec3 normal_of(const World& world, std::uint32_t triangle) {
  const glm::dvec3 a = corner_of(world, triangle, 0);
  const glm::dvec3 cross =
      glm::cross(corner_of(world, triangle, 1) - a, corner_of(world, triangle, 2) - a);
  const double length = glm::length(cross);
  return length > 0.0 ? cross / length : glm::dvec3(0.0);
}

/// The triangles of the same smooth surface in the plane of `picked`, facing the eye, as an
/// emissive world of their own.
World face_around(const RenderScene& scene, std::uint32_t picked, glm::dvec3 eye) {
  const World& world = scene.world();
  const glm::dvec3 normal = normal_of(world, picked), place = corner_of(world, picked, 0);
  const Part& part = world.parts[world.triangle_part[picked]];
  const double size = glm::distance(glm::dvec3(part.bounds.hi), glm::dvec3(part.bounds.lo));
  const bool turned = glm::dot(eye - place, normal) < 0.0;
  constexpr double parallel = 1.0 - 1e-6, in_plane = 1e-4;

  World face;
  face.materials.emplace_back();
  face.materials.back().emissive = glm::vec3(1.0f);
  for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    if (scene.features().smooth_surface(t) != scene.features().smooth_surface(picked) ||
        !(std::abs(glm::dot(normal_of(world, t), normal)) > parallel) ||
        std::abs(glm::dot(corner_of(world, t, 0) - place, normal)) > in_plane * size)
      continue;
    const auto first = static_cast<std::uint32_t>(face.positions.size());
    face.triangles.emplace_back(first, first + (turned ? 2 : 1), first + (turned ? 1 : 2));
    face.triangle_part.push_back(0);
    for (int k = 0; k < 3; ++k) {
      face.positions.push_back(world.positions[world.triangles[t][k]]);
      face.bounds.grow(face.positions.back());
    }
  }
  Part whole;
  whole.triangle_count = static_cast<std::uint32_t>(face.triangles.size());
  whole.vertex_count = static_cast<std::uint32_t>(face.positions.size());
  whole.bounds = face.bounds;
  face.parts.push_back(whole);
  return face;
}

}  // namespace

Light new_light(glm::dvec3 eye, glm::dvec3 subject, double scene_radius) {
  Light light;
  light.name = "New light";
  light.position = glm::mix(subject, eye, 0.5);
  const double distance = std::max(glm::distance(subject, light.position), 1e-3 * scene_radius);
  light.direction = (subject - light.position) / distance;
  light.radius = usual_half_size * distance;
  constexpr double radiance = 0.5;
  light.intensity = static_cast<float>(radiance * std::numbers::pi * distance * distance);
  return light;
}

std::optional<Light> light_on_face(const RenderScene& scene, std::uint32_t triangle,
                                   glm::dvec3 eye) {
  if (normal_of(scene.world(), triangle) == glm::dvec3(0.0)) return std::nullopt;
  // The outline comes from the function that makes lights of emissive meshes.
  const World face = face_around(scene, triangle, eye);
  const std::vector<Light> lights = emissive_lights(
      face, [](const World&, std::uint32_t, float, float) { return glm::vec3(1.0f); });
  const auto largest =
      std::max_element(lights.begin(), lights.end(),
                       [](const Light& a, const Light& b) { return area_of(a) < area_of(b); });
  if (largest == lights.end() || !(area_of(*largest) > 0.0)) return std::nullopt;

  Light light = *largest;
  const std::string& part = scene.world().parts[scene.world().triangle_part[triangle]].name;
  light.name = part.empty() ? "face" : "face of " + part;
  light.own_part = -1;
  light.two_sided = false;
  tidy_light(light);
  // Offset in front of the surface, which would otherwise occlude the light.
  constexpr double gap = 1e-3;
  move_light(light, gap * std::sqrt(area_of(light)) * light.direction);
  return light;
}

}  // namespace asos::ui
