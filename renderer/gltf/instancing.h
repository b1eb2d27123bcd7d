#pragma once

#include "renderer/gltf/accessors.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Returns the places of a node's mesh, relative to the node: one, or those in
/// EXT_mesh_gpu_instancing. Broken instancing data gives one copy and a warning. Faults: more than
/// `most` copies, before they are read.
[[nodiscard]] Checked<std::vector<glm::dmat4>> instance_matrices(const tinygltf::Node& node,
                                                                 const std::string& place,
                                                                 std::size_t most,
                                                                 Accessors& accessors,
                                                                 Warnings& warnings);

}  // namespace asos::gltf
