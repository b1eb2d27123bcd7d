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
/// Small is what may slip between samples a pixel apart: objects that stray from their longest line
/// by no more than the diagonal of a pixel there. Plates that are seen edge-on do not count, nor do
/// the parts of an object, nor shadows, gaps and holes. Each sphere grows by half the diagonal of
/// the square between samples, so that no place of the object is farther from the nearest corner of
/// its square.
class EnlargedSpheres {
 public:
  /// Those of `spheres` that rays of `block` can meet.
  EnlargedSpheres(std::span<const ObjectSphere> spheres, const View& view, PixelRect block);

  [[nodiscard]] bool empty() const { return near_.empty(); }

  /// Whether a ray of the block goes through the sphere of an object that it misses, before or at
  /// its hit. Samples are 2^-level pixels apart.
  [[nodiscard]] bool missed(const Ray& ray, const Hit& hit, const World& world, int level) const;

 private:
  struct Near {
    ObjectSphere sphere;
    double half_diagonal = 0.0;  // of a pixel, in the world, where that is largest in the sphere
  };
  std::vector<Near> near_;
};

}  // namespace asos
