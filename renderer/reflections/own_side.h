#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/shading/volume_path.h"
#include "renderer/world/world.h"

#include <span>

namespace asos {

/// Finds nearest hits of rays that left a volume's boundary. Skips hits of the boundary from the
/// side that a ray cannot reach without crossing the boundary first. Flat triangles of a curved
/// boundary give such hits where rays leave. Each of `hits` is the nearest of its ray.
void pass_own_side(const VolumePath& passage, const World& world, const RayScene& scene,
                   Culling faces, std::span<const Ray> rays, std::span<Hit> hits);

}  // namespace asos
