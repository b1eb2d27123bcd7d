#pragma once

#include "renderer/gltf/nodes.h"
#include "renderer/gltf/vertices.h"

namespace asos::gltf {

/// Returns the skin's matrices at the current time. Missing or broken parts are repaired with a
/// warning. Faults: the skin does not exist or has no joints.
[[nodiscard]] Checked<SkinPose> skin_pose(Document& document, Accessors& accessors,
                                          const NodeGraph& graph, int skin);

/// Moves the vertices with the joints. Positions become relative to the offset that is returned
/// (the world has double precision). Vertices without weights move with the node.
glm::dvec3 apply_skin(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const PrimitiveRequest& request, Warnings& warnings);

}  // namespace asos::gltf
