#pragma once

#include "renderer/features/feature_curve.h"
#include "renderer/features/feature_edge.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// The children of one node of the hierarchy over feature edges, in the layout that tests all of
/// them together. A child is a node or a run of edges.
struct alignas(32) FeatureNode {
  static constexpr int width = 8;
  static constexpr std::uint32_t no_chains = 0xffffffffu;

  /// Sentinel in `edge_count`: the child is a node.
  static constexpr std::uint8_t inner = 0;

  float lo[3][width];
  float hi[3][width];
  /// Double cone around the normals of all faces below; each edge's pair of normals may be flipped
  /// to fit. If no plane with such a normal through the child's box contains the viewpoint, no edge
  /// below is a silhouette. cosine <= 0: the cone contains everything.
  float axis[3][width];
  float cone_sine[width];
  float cone_cosine[width];
  std::uint32_t child[width];      ///< node, or first edge
  std::uint8_t edge_count[width];  ///< `inner`, or the number of edges of a leaf
  std::uint8_t always[width];      ///< 1: an edge below is a boundary from every viewpoint
  std::uint32_t child_count = 0;
  std::uint32_t chains = no_chains;  ///< index into FeatureHierarchy::chains; most nodes have none
};

/// The chains of a node's children. A child has one if all edges below it are boundaries from every
/// viewpoint and form one chain. It consists of the chain's two end vertices and its largest
/// distance from the straight line between them, in the world; otherwise FeatureEdge::none. If that
/// distance is small enough, the line replaces the whole chain (CGF'98 section 6.3, extended to
/// outlines).
struct NodeChains {
  std::uint32_t end[2][FeatureNode::width];
  float deviation[FeatureNode::width];

  NodeChains() {
    for (auto& ends : end) std::fill(std::begin(ends), std::end(ends), FeatureEdge::none);
    std::fill(std::begin(deviation), std::end(deviation), 0.0f);
  }
};

/// Bounding hierarchy over feature edges (design section 4). Node 0 is the root; empty without
/// edges. Building reorders `edges` so that each leaf's edges are consecutive.
struct FeatureHierarchy {
  /// Building fewer edges takes a tenth of a millisecond, which is not worth another thread.
  static constexpr std::size_t few_edges = 2048;

  std::vector<FeatureNode> nodes;
  std::vector<NodeChains> chains;

  /// Builds top-down, split by the binned sum of the boxes' extents (a thin pyramid meets a box in
  /// proportion to its width). Unconditional boundaries and possible silhouettes have separate
  /// subtrees, so that cones can reject whole meshes. Deterministic. Children of nodes with at
  /// least `fewest_in_parallel` edges are built in parallel, with the same result. Throws
  /// SearchStopped once `stop` is requested.
  static FeatureHierarchy build(std::span<const glm::vec3> positions,
                                std::vector<FeatureEdge>& edges,
                                std::span<const FeatureCurve> curves = {},
                                std::size_t fewest_in_parallel = few_edges,
                                const std::stop_token& stop = {});
};

}  // namespace asos
