#pragma once

#include "renderer/scene/contents.h"

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace asos::ui {

/// A scene's nodes that show surfaces, or have nodes below that do, as a tree. Objects are counted
/// as in SceneContents::object_nodes, hidden ones included.
class NodeTree {
 public:
  NodeTree() = default;
  explicit NodeTree(const SceneContents& contents);

  [[nodiscard]] bool empty() const { return roots_.empty(); }
  [[nodiscard]] const std::string& name(int node) const { return nodes_[index(node)].name; }
  [[nodiscard]] int parent(int node) const { return nodes_[index(node)].parent; }
  [[nodiscard]] bool has_children(int node) const { return !nodes_[index(node)].children.empty(); }
  /// The objects of the node and of all nodes below it, ascending.
  [[nodiscard]] std::vector<int> objects(int node) const;
  /// Their number.
  [[nodiscard]] std::size_t object_count(int node) const {
    return nodes_[index(node)].end - nodes_[index(node)].begin;
  }
  /// How many of them `hidden`, ascending, contains.
  [[nodiscard]] std::size_t hidden_count(int node, std::span<const int> hidden) const;

  struct Row {
    int node = -1;
    int depth = 0;
  };
  /// The rows of the tree in which the nodes of `open` show their children.
  [[nodiscard]] std::vector<Row> rows(const std::set<int>& open) const;
  /// The nodes to open at first: those on the way to the first that has several children.
  [[nodiscard]] std::set<int> open_at_first() const;
  /// The nodes above `node`.
  [[nodiscard]] std::vector<int> above(int node) const;

 private:
  struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    std::size_t begin = 0, end = 0;  // of the objects below, in order_
  };
  [[nodiscard]] static std::size_t index(int node) { return static_cast<std::size_t>(node); }

  std::vector<Node> nodes_;
  std::vector<int> roots_;
  std::vector<int> order_;  // the objects, so that those below a node stand together
};

}  // namespace asos::ui
