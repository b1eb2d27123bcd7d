#include "ui/node_tree.h"

#include <algorithm>
#include <utility>

namespace asos::ui {

NodeTree::NodeTree(const SceneContents& contents) {
  nodes_.resize(contents.nodes.size());
  std::vector<std::vector<int>> own(nodes_.size());
  std::vector<bool> shown(nodes_.size(), false);
  for (std::size_t i = 0; i < contents.object_nodes.size(); ++i) {
    const int node = contents.object_nodes[i];
    if (node >= 0 && index(node) < nodes_.size()) own[index(node)].push_back(static_cast<int>(i));
  }
  // Parents come before their children.
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    nodes_[i].name = contents.nodes[i].name;
    nodes_[i].parent = contents.nodes[i].parent;
    shown[i] = shown[i] || !own[i].empty();
    if (shown[i] && nodes_[i].parent >= 0) shown[index(nodes_[i].parent)] = true;
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!shown[i]) continue;
    std::vector<int>& among =
        nodes_[i].parent < 0 ? roots_ : nodes_[index(nodes_[i].parent)].children;
    among.push_back(static_cast<int>(i));
  }
  // Depth first; a node is visited again after its descendants.
  std::vector<std::pair<int, bool>> todo;
  for (auto root = roots_.rbegin(); root != roots_.rend(); ++root) todo.emplace_back(*root, false);
  while (!todo.empty()) {
    const auto [node, done] = todo.back();
    todo.pop_back();
    Node& n = nodes_[index(node)];
    if (done) {
      n.end = order_.size();
      continue;
    }
    n.begin = order_.size();
    order_.insert(order_.end(), own[index(node)].begin(), own[index(node)].end());
    todo.emplace_back(node, true);
    for (auto child = n.children.rbegin(); child != n.children.rend(); ++child)
      todo.emplace_back(*child, false);
  }
}

std::vector<int> NodeTree::objects(int node) const {
  const Node& n = nodes_[index(node)];
  std::vector<int> found(order_.begin() + static_cast<std::ptrdiff_t>(n.begin),
                         order_.begin() + static_cast<std::ptrdiff_t>(n.end));
  std::sort(found.begin(), found.end());
  return found;
}

std::size_t NodeTree::hidden_count(int node, std::span<const int> hidden) const {
  if (hidden.empty()) return 0;
  const Node& n = nodes_[index(node)];
  std::size_t count = 0;
  for (std::size_t i = n.begin; i < n.end; ++i)
    count += std::binary_search(hidden.begin(), hidden.end(), order_[i]) ? 1 : 0;
  return count;
}

std::vector<NodeTree::Row> NodeTree::rows(const std::set<int>& open) const {
  std::vector<Row> found, todo;
  for (auto root = roots_.rbegin(); root != roots_.rend(); ++root) todo.push_back({*root, 0});
  while (!todo.empty()) {
    const Row row = todo.back();
    todo.pop_back();
    found.push_back(row);
    if (!open.contains(row.node)) continue;
    const std::vector<int>& children = nodes_[index(row.node)].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      todo.push_back({*child, row.depth + 1});
  }
  return found;
}

std::set<int> NodeTree::open_at_first() const {
  std::set<int> open;
  const std::vector<int>* among = &roots_;
  while (among->size() == 1) {
    open.insert(among->front());
    among = &nodes_[index(among->front())].children;
  }
  return open;
}

std::vector<int> NodeTree::above(int node) const {
  std::vector<int> found;
  for (int up = parent(node); up >= 0; up = parent(up)) found.push_back(up);
  return found;
}

}  // namespace asos::ui
