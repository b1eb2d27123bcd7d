#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// Finds nearest hits of rays that left a volume's boundary, skipping the boundary's part on the
/// side that they cannot hit before its other side. Curved boundaries of flat triangles have such
/// hits where rays leave them. Each of `hits` is the nearest of its ray.
void pass_own_side(const VolumePath& passage, const World& world, const RayScene& scene,
                   Culling faces, std::span<const Ray> rays, std::span<Hit> hits);

}  // namespace asos
