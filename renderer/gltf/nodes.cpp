#include "renderer/gltf/nodes.h"

#include "renderer/geometry/finite.h"
#include "renderer/gltf/values.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

glm::dmat4 NodePose::parent_from_node() const {
  if (matrix) return *matrix;
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), translation);
  return glm::scale(moved * glm::mat4_cast(rotation), scale);
}

NodeGraph::NodeGraph(Document& document, std::vector<NodePose> poses)
    : doc_(document), poses_(std::move(poses)) {
  link();
  cut_cycles();
  place();
}

void NodeGraph::link() {
  const auto count = static_cast<int>(poses_.size());
  parent_.assign(poses_.size(), -1);
  for (int node = 0; node < count; ++node) {
    for (const int child : doc_.model.nodes[static_cast<std::size_t>(node)].children) {
      if (child < 0 || child >= count) {
        doc_.warnings.add_loss(
            fmt::format("node {} has child {}, which does not exist", node, child));
        continue;
      }
      int& parent = parent_[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        doc_.warnings.add(
            fmt::format("node {} is a child of both node {} and node {}; the second "
                        "is ignored",
                        child, parent, node));
        continue;
      }
      parent = node;
    }
  }
}

void NodeGraph::cut_cycles() {
  // Walk up from every node; a walk that meets itself is a cycle.
  std::vector<int> seen_by(poses_.size(), -1);
  for (std::size_t start = 0; start < poses_.size(); ++start) {
    auto node = static_cast<int>(start);
    while (node >= 0 && seen_by[static_cast<std::size_t>(node)] < 0) {
      seen_by[static_cast<std::size_t>(node)] = static_cast<int>(start);
      int& up = parent_[static_cast<std::size_t>(node)];
      if (up >= 0 && seen_by[static_cast<std::size_t>(up)] == static_cast<int>(start)) {
        doc_.warnings.add_loss(fmt::format("node {} is among its own descendants", up));
        up = -1;
      }
      node = up;
    }
  }
  children_.resize(poses_.size());
  for (std::size_t node = 0; node < poses_.size(); ++node) {
    if (parent_[node] >= 0) {
      children_[static_cast<std::size_t>(parent_[node])].push_back(static_cast<int>(node));
    }
  }
}

void NodeGraph::place() {
  world_.assign(poses_.size(), glm::dmat4(1.0));
  std::vector<int> todo;
  for (std::size_t node = 0; node < poses_.size(); ++node) {
    if (parent_[node] < 0) todo.push_back(static_cast<int>(node));
  }
  while (!todo.empty()) {
    const int node = todo.back();
    todo.pop_back();
    const auto n = static_cast<std::size_t>(node);
    const glm::dmat4 own = poses_[n].parent_from_node();
    world_[n] = parent_[n] < 0 ? own : world_[static_cast<std::size_t>(parent_[n])] * own;
    todo.insert(todo.end(), children_[n].begin(), children_[n].end());
  }
}

std::vector<NodeGraph::Listed> NodeGraph::listed(int scene) const {
  const std::vector<tinygltf::Node>& nodes = doc_.model.nodes;
  const auto count = static_cast<int>(nodes.size());
  std::vector<bool> done(nodes.size(), false);
  for (const tinygltf::Node& node : nodes) {
    const tinygltf::Value* lod = extension(node.extensions, "MSFT_lod");
    for (int i = 0; lod && lod->Has("ids") && i < static_cast<int>(lod->Get("ids").ArrayLen());
         ++i) {
      const tinygltf::Value& id = lod->Get("ids").Get(i);
      const int coarser = id.IsInt() ? id.GetNumberAsInt() : -1;
      if (coarser >= 0 && coarser < count) done[static_cast<std::size_t>(coarser)] = true;
    }
  }

  std::vector<int> todo;
  if (scene >= 0) {
    todo = doc_.model.scenes[static_cast<std::size_t>(scene)].nodes;
  } else {
    for (int node = 0; node < count; ++node) {
      if (parent_[static_cast<std::size_t>(node)] < 0) todo.push_back(node);
    }
  }
  for (int& node : todo) {
    if (node < 0 || node >= count) {
      doc_.warnings.add_loss(fmt::format("the scene has node {}, which does not exist", node));
    } else if (parent_[static_cast<std::size_t>(node)] >= 0) {
      doc_.warnings.add(fmt::format("the scene lists node {}, which is not a root", node));
    }
  }
  std::reverse(todo.begin(), todo.end());
  std::vector<Listed> order;
  std::vector<bool> visible(nodes.size(), true);  // with all above
  while (!todo.empty()) {
    const int node = todo.back();
    todo.pop_back();
    if (node < 0 || node >= count || done[static_cast<std::size_t>(node)]) continue;
    const auto n = static_cast<std::size_t>(node);
    done[n] = true;
    const int parent = parent_[n];
    visible[n] = poses_[n].visible && (parent < 0 || visible[static_cast<std::size_t>(parent)]);
    const bool placed = finite(world_[n]);
    if (visible[n] && !placed)
      doc_.warnings.add_loss(fmt::format("node {} is placed at infinity; not drawn", node));
    order.push_back({node, visible[n] && placed});
    todo.insert(todo.end(), children_[n].rbegin(), children_[n].rend());
  }
  return order;
}

}  // namespace asos::gltf
