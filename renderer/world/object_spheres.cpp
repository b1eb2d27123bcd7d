#include "renderer/world/object_spheres.h"

#include <array>
#include <cmath>
#include <span>

namespace asos {
namespace {

// Returns the vertex of a part with the largest distance2.
template <typename Distance2>
glm::dvec3 farthest(std::span<const glm::vec3> vertices, Distance2 distance2) {
  double most = -1.0;
  glm::dvec3 found(0.0);
  for (const glm::vec3& v : vertices) {
    const double d = distance2(glm::dvec3(v));
    if (d > most) most = d, found = glm::dvec3(v);
  }
  return found;
}

double length2(glm::dvec3 v) {
  return glm::dot(v, v);
}

ObjectSphere sphere_around(std::span<const glm::vec3> vertices) {
  Box box;
  for (const glm::vec3& v : vertices) box.grow(v);
  ObjectSphere sphere;
  sphere.centre = 0.5 * (glm::dvec3(box.lo) + glm::dvec3(box.hi));
  const auto from = [](glm::dvec3 p) { return [p](glm::dvec3 v) { return length2(v - p); }; };
  const glm::dvec3 a = farthest(vertices, from(sphere.centre));
  sphere.radius = glm::length(a - sphere.centre);
  const glm::dvec3 line = farthest(vertices, from(a)) - a;
  if (!(length2(line) > 0.0)) return sphere;
  const glm::dvec3 along = glm::normalize(line);
  const auto off_line = [&](glm::dvec3 v) { return length2(glm::cross(v - a, along)); };
  sphere.thickness = std::sqrt(off_line(farthest(vertices, off_line)));
  return sphere;
}

/// Returns the spheres of shared meshes, in their own spaces.
std::vector<ObjectSphere> spheres_of_meshes(const World& world) {
  std::vector<ObjectSphere> spheres;
  if (!world.placements) return spheres;
  for (const auto& mesh : world.placements->meshes)
    spheres.push_back(sphere_around(mesh->positions.own()));
  return spheres;
}

/// Returns the sphere of a shared mesh at one of its places.
ObjectSphere placed_sphere(const Placements& all, const Placement& place, ObjectSphere sphere) {
  sphere.centre = glm::dvec3(all.world_from_mesh(place) * glm::dvec4(sphere.centre, 1.0));
  sphere.radius *= place.most_growth;
  sphere.thickness *= place.most_growth;
  return sphere;
}

}  // namespace

std::vector<ObjectSphere> object_spheres(const World& world) {
  std::vector<ObjectSphere> spheres;
  const std::vector<ObjectSphere> of_meshes = spheres_of_meshes(world);
  for (std::uint32_t i = 0; i < world.parts.size(); ++i) {
    const Part& part = world.parts[i];
    if (part.face_count > 0) {
      const glm::vec3 &lo = part.bounds.lo, &hi = part.bounds.hi;
      std::array<glm::vec3, 8> corners;
      for (std::size_t c = 0; c < corners.size(); ++c)
        corners[c] = {c & 1 ? hi.x : lo.x, c & 2 ? hi.y : lo.y, c & 4 ? hi.z : lo.z};
      spheres.push_back(sphere_around(corners));
    } else if (part.vertex_count > 0 && world.is_placed(part.first_triangle)) {
      const Placement& place = world.placements->of_triangle(part.first_triangle);
      spheres.push_back(placed_sphere(*world.placements, place, of_meshes[place.mesh]));
    } else if (part.vertex_count > 0) {
      spheres.push_back(sphere_around(
          std::span(world.positions.own()).subspan(part.first_vertex, part.vertex_count)));
    } else {
      continue;
    }
    spheres.back().part = i;
  }
  return spheres;
}

}  // namespace asos
