#pragma once

#include "renderer/gltf/accessors.h"
#include "renderer/gltf/load.h"
#include "renderer/gltf/nodes.h"
#include "renderer/gltf/primitive.h"
#include "renderer/gltf/skin.h"
#include "renderer/scene/scene.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace asos::gltf {

/// Key of a scene's mesh: the document's mesh and primitive, and the morph weights.
using MeshKey = std::tuple<int, int, std::vector<double>>;

/// Meshes that do not change with time, for the next import of the same document; nullopt: left
/// out.
struct StaticMeshes {
  bool wanted = false;
  std::set<std::size_t> morphing_nodes;    ///< those whose weights an animation moves
  std::set<std::size_t> moving_materials;  ///< animated: may need tangents only at some times
  std::map<MeshKey, std::optional<Mesh>> meshes;
};

/// Converts a document to a scene, node by node, for one moment. Broken parts are left out, with a
/// warning in the document.
class Importer {
 public:
  Importer(Document& document, Accessors& accessors, const NodeGraph& graph, StaticMeshes& still,
           const LoadOptions& options)
      : doc_(document), accessors_(accessors), graph_(graph), still_(still), options_(options) {}

  /// Adds the document's scene `scene`, or all nodes for -1, to `base`, which has the materials.
  /// Faults: it is too large, or nothing of it can be drawn because everything is broken.
  [[nodiscard]] Checked<Scene> run(int scene, Scene base);

 private:
  [[nodiscard]] Checked<void> add_mesh(int index, const tinygltf::Node& node);
  [[nodiscard]] Checked<void> add_shape(int index, const tinygltf::Node& node, const Shape& shape);
  [[nodiscard]] Checked<void> add_primitive(int index, int p, const SkinPose* skin,
                                            const std::vector<glm::dmat4>& copies);
  [[nodiscard]] bool is_drawn(int mode, const std::string& place);
  [[nodiscard]] int load(int index, int p, const SkinPose* skin, const std::string& place,
                         glm::dmat4& world_from_mesh);
  [[nodiscard]] std::optional<Mesh> load_mesh(PrimitiveRequest request, const std::string& name,
                                              glm::dmat4& world_from_mesh);
  [[nodiscard]] int material_of(const tinygltf::Primitive& primitive, const std::string& place);
  void check_unshown();
  [[nodiscard]] Checked<void> check_drawn();

  Document& doc_;
  Accessors& accessors_;
  const NodeGraph& graph_;
  StaticMeshes& still_;
  const LoadOptions& options_;
  Scene scene_;
  std::map<MeshKey, int> meshes_;  // indices of the scene's meshes
  std::set<std::size_t> shown_;    // the document's meshes that nodes use
  std::map<int, Checked<SkinPose>> skins_;
  std::uint64_t triangles_ = 0;
  int nodes_ = 0;  // number of added nodes
  int node_ = -1;  // index of the current node, among the visible ones
};

}  // namespace asos::gltf
