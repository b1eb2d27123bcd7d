#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// The plane of a flat mirror. Reflected rays leave it and never hit it again.
struct MirrorPlane {
  HalfSpace above;  ///< the side to which reflected rays lead; unit normal
  /// Largest height above the plane of a ray's hit with a surface in it, because of rounding.
  double hit_tolerance = 0.0;
};

/// Finds nearest hits of rays that left a mirror, skipping triangles in its plane. A triangle is in
/// the plane if all its corners are, within single precision. Each of `hits` is the nearest of its
/// ray; `rays` are moved behind the skipped hits.
void pass_mirror(const MirrorPlane& plane, const World& world, const RayScene& scene, Culling faces,
                 std::span<Ray> rays, std::span<Hit> hits);

}  // namespace asos
