#pragma once

#include "renderer/features/hierarchy.h"
#include "renderer/geometry/frame.h"

namespace asos {

/// A frame's numbers in the layout of the eight-wide node test.
struct NodeTestFrame {
  explicit NodeTestFrame(const Frame& frame);

  float apex[3];
  float direction[3];
  float row[3][3];  // U, V, W
  float row_abs[3][3];
  float opposite[2][3];  // W - U and W - V of a pyramid
  float opposite_abs[2][3];
  bool parallel;
};

/// The children of a node that are kept: the rectangle of each in the frame and its greatest
/// nearness.
struct NodeTestResult {
  unsigned kept = 0;  ///< bit i: child i may contain a boundary in the square
  float u0[FeatureNode::width];
  float v0[FeatureNode::width];
  float u1[FeatureNode::width];
  float v1[FeatureNode::width];
  float nearness[FeatureNode::width];
};

/// Tests all children of a node. Drops those outside the pyray, and those with no silhouette seen
/// from the apex (by the cone of their normals) and no other boundary. Conservative in single
/// precision.
[[nodiscard]] NodeTestResult test_children(const FeatureNode& node, const NodeTestFrame& frame);

}  // namespace asos
