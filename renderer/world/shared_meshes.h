#pragma once

#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <memory>
#include <vector>

// Selects the meshes that a world stores once for several instances.

namespace asos {

/// Returns one flag per instance of a scene: 1 if its mesh is stored once. Empty: none is. Shared
/// meshes are large: their copies would have `fewest_copied` triangles or more. They are opaque and
/// do not emit, since lamps and cut-outs have their own data for each triangle. The instances'
/// matrices distort little, so that all places of a mesh have the same boundary edges. Scenes with
/// lines, points or analytic shapes share none, since these are numbered after all triangles.
[[nodiscard]] std::vector<std::uint8_t> shared_instances(const Scene& scene,
                                                         std::uint64_t fewest_copied);

/// Returns the world of one mesh of a scene, in the mesh's own space and with its own material.
[[nodiscard]] std::shared_ptr<const World> shared_mesh(const Scene& scene, int mesh);

}  // namespace asos
