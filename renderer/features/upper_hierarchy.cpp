#include "renderer/features/upper_hierarchy.h"

#include <algorithm>
#include <span>
#include <utility>

namespace asos {
namespace {

using Items = std::span<UpperItem>;

glm::vec3 centre_of(const UpperItem& item) {
  return 0.5f * item.box.lo + 0.5f * item.box.hi;
}

/// Splits items into two halves along the longest side of the box of all centres.
std::pair<Items, Items> halves_of(Items items) {
  Box centres;
  for (const UpperItem& item : items) centres.grow(centre_of(item));
  const glm::vec3 size = centres.hi - centres.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [axis](const UpperItem& a, const UpperItem& b) {
                     const float x = centre_of(a)[axis], y = centre_of(b)[axis];
                     return x != y ? x < y : a.place < b.place;
                   });
  return {items.first(half), items.subspan(half)};
}

std::vector<Items> in_eight_parts(Items items) {
  std::vector<Items> parts{items};
  while (parts.size() < FeatureNode::width) {
    const auto largest = std::max_element(parts.begin(), parts.end(),
                                          [](Items x, Items y) { return x.size() < y.size(); });
    if (largest->size() < 2) break;
    const auto [left, right] = halves_of(*largest);
    *largest = left;
    parts.insert(largest + 1, right);
  }
  return parts;
}

void fill_upper(std::vector<FeatureNode>& nodes, std::uint32_t index, Items items) {
  const std::vector<Items> parts = in_eight_parts(items);
  nodes[index].child_count = static_cast<std::uint32_t>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Box box;
    for (const UpperItem& item : parts[i]) box.grow(item.box);
    const bool root = parts[i].size() == 1;
    const auto child = root ? parts[i].front().place : static_cast<std::uint32_t>(nodes.size());
    FeatureNode& node = nodes[index];
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = box.lo[k];
      node.hi[k][i] = box.hi[k];
      node.axis[k][i] = k == 2 ? 1.0f : 0.0f;
    }
    node.cone_sine[i] = 1.0f;
    node.cone_cosine[i] = 0.0f;
    node.child[i] = child;
    node.edge_count[i] = root ? root_below : FeatureNode::inner;
    node.always[i] = 1;
    if (root) continue;
    nodes.emplace_back();
    fill_upper(nodes, child, parts[i]);
  }
}

}  // namespace

Box box_below(const FeatureNode& node) {
  Box box;
  for (std::uint32_t c = 0; c < node.child_count; ++c) {
    box.grow(glm::vec3(node.lo[0][c], node.lo[1][c], node.lo[2][c]));
    box.grow(glm::vec3(node.hi[0][c], node.hi[1][c], node.hi[2][c]));
  }
  return box;
}

std::vector<FeatureNode> upper_nodes(std::vector<UpperItem> items,
                                     const std::vector<FeatureNode>& own) {
  if (!own.empty()) items.push_back({box_below(own[0]), UpperItem::own});
  std::vector<FeatureNode> nodes;
  if (items.empty()) return nodes;
  nodes.emplace_back();
  fill_upper(nodes, 0, items);
  return nodes;
}

}  // namespace asos
