#include "renderer/methods/whitted_spheres.h"

#include "renderer/shading/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// Of the vertices of a part.
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

}  // namespace

std::vector<ObjectSphere> object_spheres(const World& world) {
  std::vector<ObjectSphere> spheres;
  for (std::uint32_t i = 0; i < world.parts.size(); ++i) {
    const Part& part = world.parts[i];
    if (part.face_count > 0) {
      const glm::vec3 &lo = part.bounds.lo, &hi = part.bounds.hi;
      std::array<glm::vec3, 8> corners;
      for (std::size_t c = 0; c < corners.size(); ++c)
        corners[c] = {c & 1 ? hi.x : lo.x, c & 2 ? hi.y : lo.y, c & 4 ? hi.z : lo.z};
      spheres.push_back(sphere_around(corners));
    } else if (part.vertex_count > 0) {
      spheres.push_back(
          sphere_around(std::span(world.positions).subspan(part.first_vertex, part.vertex_count)));
    } else {
      continue;
    }
    spheres.back().part = i;
  }
  return spheres;
}

EnlargedSpheres::EnlargedSpheres(std::span<const ObjectSphere> spheres, const View& view,
                                 PixelRect block) {
  const PixelSpacing spacing = PixelSpacing::of(view);
  const glm::dvec3 forward(spacing.forward), right(spacing.right), down(spacing.down);
  const Frame frame = view.frame(block.x, block.y, block.width, block.height);
  const glm::dvec3 ahead = frame.direction();
  // Rays may start ahead of the apex, each at a place of its own.
  const glm::dvec3 eye =
      frame.parallel()
          ? glm::dvec3(view.ray(block.x + 0.5 * block.width, block.y + 0.5 * block.height).origin)
          : frame.apex();
  const double per_cosine = 1.0 / glm::dot(ahead, forward);
  const auto half_diagonal = [&](double width, double height) {
    return 0.5 * std::max(glm::length(width * right + height * down),
                          glm::length(width * right - height * down));
  };
  const double pixel = half_diagonal(1, 1);
  const double whole = half_diagonal(block.width, block.height);
  for (const ObjectSphere& sphere : spheres) {
    const double depth = glm::dot(sphere.centre - eye, forward);
    // Lengths in the picture are those one unit ahead of the eye.
    const double farthest = spacing.perspective ? depth + sphere.radius : 1.0;
    const Near near{sphere, pixel * farthest};
    // A plane across the view at the farthest point is no wider between samples anywhere before.
    if (!(farthest > 0.0) || sphere.thickness > 2.0 * near.half_diagonal) continue;
    // No point of the pyramid around the block is farther from its middle ray, at the same depth.
    const glm::dvec3 on_middle = eye + depth * per_cosine * ahead;
    const double enlarged = sphere.radius + near.half_diagonal;
    const double reach = enlarged * (1.0 + per_cosine) + whole * (farthest + near.half_diagonal);
    if (glm::length(sphere.centre - on_middle) <= reach) near_.push_back(near);
  }
}

bool EnlargedSpheres::missed(const Ray& ray, const Hit& hit, const World& world, int level) const {
  const glm::dvec3 eye(ray.origin), direction(ray.direction);
  const double part_of_pixel = std::ldexp(1.0, -level);
  const double hit_distance =
      hit.valid() ? static_cast<double>(hit.t) : std::numeric_limits<double>::infinity();
  return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
    const double radius = near.sphere.radius + part_of_pixel * near.half_diagonal;
    const glm::dvec3 to_centre = near.sphere.centre - eye;
    const double along = glm::dot(to_centre, direction);
    const double inside2 = radius * radius - length2(to_centre - along * direction);
    if (!(inside2 >= 0.0)) return false;
    const double half_chord = std::sqrt(inside2);
    if (along + half_chord < 0.0 || along - half_chord > hit_distance) return false;
    return !hit.valid() || world.triangle_part[hit.triangle] != near.sphere.part;
  });
}

}  // namespace asos
