#pragma once

#include "renderer/scene/contents.h"

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace asos::ui {

/// The tree of a scene's nodes that have surfaces, or descendants that have. Objects are indexed as
/// in SceneContents::object_nodes, with hidden ones included.
class NodeTree {
 public:
  NodeTree() = default;
  explicit NodeTree(const SceneContents& contents);

  [[nodiscard]] bool empty() const { return roots_.empty(); }
  [[nodiscard]] const std::string& name(int node) const { return nodes_[index(node)].name; }
  [[nodiscard]] int parent(int node) const { return nodes_[index(node)].parent; }
  [[nodiscard]] bool has_children(int node) const { return !nodes_[index(node)].children.empty(); }
  /// Ascending indices of the objects of the node and its descendants.
  [[nodiscard]] std::vector<int> objects(int node) const;
  /// Number of objects of the node and its descendants.
  [[nodiscard]] std::size_t object_count(int node) const {
    return nodes_[index(node)].end - nodes_[index(node)].begin;
  }
  /// Number of those objects that are in `hidden` (ascending).
  [[nodiscard]] std::size_t hidden_count(int node, std::span<const int> hidden) const;

  struct Row {
    int node = -1;
    int depth = 0;
  };
  /// The rows of the tree when the nodes in `open` are unfolded.
  [[nodiscard]] std::vector<Row> rows(const std::set<int>& open) const;
  /// The nodes to unfold at first: those down to the first node with several children.
  [[nodiscard]] std::set<int> open_at_first() const;
  /// The nodes above `node`.
  [[nodiscard]] std::vector<int> above(int node) const;

 private:
  struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    std::size_t begin = 0, end = 0;  // range of its objects in order_
  };
  [[nodiscard]] static std::size_t index(int node) { return static_cast<std::size_t>(node); }

  std::vector<Node> nodes_;
  std::vector<int> roots_;
  std::vector<int> order_;  // the objects, ordered so that those of a subtree are contiguous
};

}  // namespace asos::ui
