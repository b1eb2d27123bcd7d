#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// The plane of a flat mirror: what reflected rays leave, and never meet again.
struct MirrorPlane {
  HalfSpace above;  ///< where they lead; unit normal
  double hit_tolerance =
      0.0;  ///< so far above it a ray may seem to meet what lies in it, by rounding
};

/// Nearest hits of rays that left a mirror, past what lies in its plane: triangles whose corners
/// all do, as closely as single precision has them. Each of `hits` is the nearest of its ray;
/// `rays` go on behind what they should not have met.
void pass_mirror(const MirrorPlane& plane, const World& world, const RayScene& scene, Culling faces,
                 std::span<Ray> rays, std::span<Hit> hits);

}  // namespace asos
