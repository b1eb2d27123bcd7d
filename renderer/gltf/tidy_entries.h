#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <set>

namespace asos::gltf {

/// Replaces entries of a document's lists that tinygltf would refuse the whole file for by ones
/// that stand for nothing, so that the numbers of the others stay: accessors without elements,
/// views of no buffer, lights of no type. Each is a warning, and a loss where it can hold
/// something to draw. Returns the numbers of the cameras that are left out. Before the rest of the
/// document is tidied.
[[nodiscard]] std::set<std::size_t> tidy_entries(nlohmann::json& root, Warnings& warnings);

/// Gives cameras the planes that tinygltf asks for and that they lack: ones that are not valid, and
/// so cut nothing off. After the rest of the document is tidied.
void complete_planes(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
