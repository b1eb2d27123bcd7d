#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// Nearest hits of rays that left a volume's boundary, past what they cannot meet before they have
/// met its other side: the boundary's part from the side that faces away from where they are. Bent
/// ones, of flat triangles, are met so where rays leave them. Each of `hits` is the nearest of its
/// ray.
void pass_own_side(const VolumePath& passage, const World& world, const RayScene& scene,
                   Culling faces, std::span<const Ray> rays, std::span<Hit> hits);

}  // namespace asos
