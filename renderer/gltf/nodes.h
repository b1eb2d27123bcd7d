#pragma once

#include "renderer/gltf/accessors.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <optional>
#include <vector>

namespace asos::gltf {

/// A node's own transformation and morph weights at one time.
struct NodePose {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 scale{1.0};
  std::optional<glm::dmat4> matrix;  ///< replaces the three above
  std::vector<double> weights;       ///< of morph targets; empty: the mesh's weights
  bool visible = true;               ///< KHR_node_visibility: includes everything below it

  [[nodiscard]] glm::dmat4 parent_from_node() const;
};

/// Returns the pose of every node as the file defines it.
[[nodiscard]] std::vector<NodePose> poses_at_rest(Document& document);

/// Returns a unit quaternion. Repairs an invalid one, with a warning.
[[nodiscard]] glm::dquat unit_rotation(glm::dquat q, const std::string& place, Warnings& warnings);

/// A file's node hierarchy as a forest: references to missing nodes, second parents and cycles are
/// cut with a warning. Nothing here recurses.
class NodeGraph {
 public:
  NodeGraph(Document& document, std::vector<NodePose> poses);

  [[nodiscard]] const glm::dmat4& world_from_node(int node) const {
    return world_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] const NodePose& pose(int node) const {
    return poses_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  /// Returns -1 for roots.
  [[nodiscard]] int parent(int node) const { return parent_[static_cast<std::size_t>(node)]; }

  /// A node of a scene. Invisible subtrees (KHR_node_visibility) and nodes whose place is not
  /// finite are not shown.
  struct Listed {
    int node = -1;
    bool shown = true;
  };
  /// Returns the nodes of a scene, parents first, each once. Leaves out coarser levels of detail
  /// (MSFT_lod). The order is the same in all poses. `scene` -1: all.
  [[nodiscard]] std::vector<Listed> listed(int scene) const;

 private:
  void link();
  void cut_cycles();
  void place();

  Document& doc_;
  std::vector<NodePose> poses_;
  std::vector<int> parent_;
  std::vector<std::vector<int>> children_;
  std::vector<glm::dmat4> world_;
};

}  // namespace asos::gltf
