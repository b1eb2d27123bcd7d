#pragma once

#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

// Selects the meshes that a world stores once for several instances.

namespace asos {

/// The meshes of an animated scene that keep their shape, for its worlds at several times to store
/// them once.
class MeshStore {
 public:
  /// Keeps the meshes of one pose.
  explicit MeshStore(const Scene& pose);

  /// Drops the meshes that differ in another pose; `flatten` calls it.
  void compare(const Scene& pose);
  /// Returns whether any were dropped since the last call, so that earlier worlds share others.
  [[nodiscard]] bool take_dropped() { return std::exchange(dropped_, false); }
  /// Returns whether a mesh of the scene keeps its shape.
  [[nodiscard]] bool keeps(int mesh) const { return kept_[static_cast<std::size_t>(mesh)] != 0; }
  [[nodiscard]] bool empty() const;
  /// Returns the world of a mesh as shared_mesh does, the same one each time.
  [[nodiscard]] std::shared_ptr<const World> world_of(const Scene& scene, int mesh);

 private:
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  std::vector<std::uint8_t> kept_;  // by mesh
  bool dropped_ = false;
  std::map<int, std::shared_ptr<const World>> worlds_;
};

/// Flattens a scene as `flatten` does. All meshes that the store keeps are stored once, however few
/// instances they have, if they can be shared at all.
[[nodiscard]] Result<FlattenedScene> flatten(const Scene& scene, std::uint64_t max_triangles,
                                             glm::dvec3 origin, MeshStore& meshes);

/// Returns one flag per instance of a scene: 1 if its mesh is stored once. Empty: none is. Shared
/// meshes are large: their copies would have `fewest_copied` triangles or more. They are opaque and
/// do not emit, since lamps and cut-outs have their own data for each triangle. The instances'
/// matrices distort little, so that all places of a mesh have the same boundary edges. Scenes with
/// lines, points or analytic shapes share none, since these are numbered after all triangles.
[[nodiscard]] std::vector<std::uint8_t> shared_instances(const Scene& scene,
                                                         std::uint64_t fewest_copied);
/// The same for all meshes that `meshes` keeps.
[[nodiscard]] std::vector<std::uint8_t> shared_instances(const Scene& scene,
                                                         const MeshStore& meshes);

/// Returns the world of one mesh of a scene, in the mesh's own space and with its own material.
[[nodiscard]] std::shared_ptr<const World> shared_mesh(const Scene& scene, int mesh);

}  // namespace asos
