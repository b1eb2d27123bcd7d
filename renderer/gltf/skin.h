#pragma once

#include "renderer/gltf/nodes.h"
#include "renderer/gltf/vertices.h"

namespace asos::gltf {

/// The skin's matrices at the time that is shown. Missing or broken parts are repaired with a
/// warning. Faults: the skin does not exist or has no joints.
[[nodiscard]] Checked<SkinPose> skin_pose(Document& document, Accessors& accessors,
                                          const NodeGraph& graph, int skin);

/// Moves the vertices to where the joints carry them; positions become relative to the offset that
/// is returned (the world is kept in double precision). Vertices without weights go with the node.
glm::dvec3 apply_skin(VertexData& data, std::vector<glm::uvec3>& triangles,
                      const PrimitiveRequest& request, Warnings& warnings);

}  // namespace asos::gltf
