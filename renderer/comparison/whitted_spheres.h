#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/geometry/view.h"
#include "renderer/world/object_spheres.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Whitted's bounding spheres in one block of a picture (Whitted 1980, "An improved illumination
/// model for shaded display"; CGF'98 section 2.3: "surrounding each small object with a bounding
/// sphere sufficiently large so that if the object projection intersects a pixel, then at least one
/// of the 4 rays will intersect the sphere").
///
/// An object is small if it can fall between samples one pixel apart: its distance from its longest
/// line is at most the diagonal of a pixel there. Edge-on plates, parts of objects, shadows, gaps
/// and holes are not handled. Each sphere is enlarged by half the diagonal of the square between
/// samples, so that every point of the object is within reach of the nearest corner of its square.
class EnlargedSpheres {
 public:
  /// Keeps those of `spheres` that rays of `block` can hit.
  EnlargedSpheres(std::span<const ObjectSphere> spheres, const View& view, PixelRect block);

  [[nodiscard]] bool empty() const { return near_.empty(); }

  /// Returns whether a ray of the block passes through the sphere of an object that it misses, at
  /// or before its hit. Samples are 2^-level pixels apart.
  [[nodiscard]] bool missed(const Ray& ray, const Hit& hit, const World& world, int level) const;

 private:
  struct Near {
    ObjectSphere sphere;
    double half_diagonal = 0.0;  // of a pixel, in world units, at the sphere's most distant point
  };
  std::vector<Near> near_;
};

}  // namespace asos
