#include "renderer/comparison/whitted_spheres.h"

#include "renderer/shading/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {
namespace {

double length2(glm::dvec3 v) {
  return glm::dot(v, v);
}

}  // namespace

EnlargedSpheres::EnlargedSpheres(std::span<const ObjectSphere> spheres, const View& view,
                                 PixelRect block) {
  const PixelSpacing spacing = PixelSpacing::of(view);
  const glm::dvec3 forward(spacing.forward), right(spacing.right), down(spacing.down);
  const Frame frame = view.frame(block.x, block.y, block.width, block.height);
  const glm::dvec3 ahead = frame.direction();
  // Rays may start in front of the apex, each at a different point.
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
    // Distances in the picture are at unit distance from the eye.
    const double farthest = spacing.perspective ? depth + sphere.radius : 1.0;
    const Near near{sphere, pixel * farthest};
    // The spacing of samples is largest in the plane across the view at the farthest point.
    if (!(farthest > 0.0) || sphere.thickness > 2.0 * near.half_diagonal) continue;
    // At any depth, all points of the pyramid around the block are within this distance of its
    // central ray.
    const glm::dvec3 on_middle = eye + depth * per_cosine * ahead;
    const double enlarged = sphere.radius + near.half_diagonal;
    const double reach = enlarged * (1.0 + per_cosine) + whole * (farthest + near.half_diagonal);
    if (glm::length(sphere.centre - on_middle) <= reach) near_.push_back(near);
  }
}

bool EnlargedSpheres::missed(const Ray& ray, const Hit& hit, const World& world, int level) const {
  const glm::dvec3 eye(ray.origin), direction(ray.direction);
  const double part_of_pixel = std::ldexp(1.0, -level);
  const double hit_distance = static_cast<double>(hit.valid() ? hit.t : ray.t_far);
  return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
    const double radius = near.sphere.radius + part_of_pixel * near.half_diagonal;
    const glm::dvec3 to_centre = near.sphere.centre - eye;
    const double along = glm::dot(to_centre, direction);
    const double inside2 = radius * radius - length2(to_centre - along * direction);
    if (!(inside2 >= 0.0)) return false;
    const double half_chord = std::sqrt(inside2);
    if (along + half_chord < static_cast<double>(ray.t_near) || along - half_chord > hit_distance)
      return false;
    return !hit.valid() || world.triangle_part[hit.triangle] != near.sphere.part;
  });
}

}  // namespace asos
