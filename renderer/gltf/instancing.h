#pragma once

#include "renderer/gltf/accessors.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Where a node's mesh is drawn, relative to the node: once, or as often as
/// EXT_mesh_gpu_instancing says. Broken instancing data gives one copy and a warning. Faults: more
/// than `most` copies, before they are read.
[[nodiscard]] Checked<std::vector<glm::dmat4>> instance_matrices(const tinygltf::Node& node,
                                                                 const std::string& place,
                                                                 std::size_t most,
                                                                 Accessors& accessors,
                                                                 Warnings& warnings);

}  // namespace asos::gltf
