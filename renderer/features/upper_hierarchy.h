#pragma once

#include "renderer/features/hierarchy.h"
#include "renderer/geometry/box.h"

#include <cstdint>
#include <vector>

// The nodes above the hierarchies of a world's own boundaries and of its placed meshes.

namespace asos {

/// The hierarchy of one place of a mesh, by its box.
struct UpperItem {
  static constexpr std::uint32_t own = 0xffffffffu;

  Box box;
  std::uint32_t place = own;  ///< `own`: the world's own boundaries
};

/// Returns the box of everything below a node.
[[nodiscard]] Box box_below(const FeatureNode& node);

/// Returns the nodes above the places' hierarchies and above `own`, unless that is empty; the first
/// is the root. finish_upper_nodes numbers the children that are roots of hierarchies.
[[nodiscard]] std::vector<FeatureNode> upper_nodes(std::vector<UpperItem> items,
                                                   const std::vector<FeatureNode>& own);

/// Marks such children; never in a finished node.
inline constexpr std::uint8_t root_below = 255;

/// Numbers the roots below upper nodes; that of the own hierarchy is `own_root`.
template <typename RootOf>
void finish_upper_nodes(std::vector<FeatureNode>& nodes, std::uint32_t own_root,
                        RootOf root_of_place) {
  for (FeatureNode& node : nodes) {
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      if (node.edge_count[c] != root_below) continue;
      node.edge_count[c] = FeatureNode::inner;
      node.child[c] = node.child[c] == UpperItem::own ? own_root : root_of_place(node.child[c]);
    }
  }
}

}  // namespace asos
