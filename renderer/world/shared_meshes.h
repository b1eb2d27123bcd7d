#pragma once

#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <memory>
#include <vector>

// The choice of meshes that a world keeps once for several instances.

namespace asos {

/// Returns one flag per instance of a scene: 1 if its mesh is kept once. Empty: none is. These are
/// large meshes whose copies would have `fewest_copied` triangles or more. They are opaque and do
/// not shine, for lamps and cut-outs have data of their own for each triangle. The instances'
/// matrices distort little, so that the edges which bound one place of a mesh bound the others.
/// Scenes with lines, points or analytic shapes share none, since these are numbered after all
/// triangles.
[[nodiscard]] std::vector<std::uint8_t> shared_instances(const Scene& scene,
                                                         std::uint64_t fewest_copied);

/// The world of one mesh of a scene, in the mesh's own space and with its own material.
[[nodiscard]] std::shared_ptr<const World> shared_mesh(const Scene& scene, int mesh);

}  // namespace asos
