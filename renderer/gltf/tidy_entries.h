#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <set>

namespace asos::gltf {

/// Replaces entries of a document's lists for which tinygltf would reject the whole file by neutral
/// ones, so that the others keep their numbers: accessors without elements, views of no buffer,
/// lights of no type. Each is a warning, and a loss if it may contain something to draw. Returns
/// the numbers of the cameras that are left out. Must be called before the rest of the document is
/// tidied.
[[nodiscard]] std::set<std::size_t> tidy_entries(nlohmann::json& root, Warnings& warnings);

/// Adds the near and far planes that tinygltf requires to cameras without them. Their values are
/// invalid, so they do not clip. Must be called after the rest of the document is tidied.
void complete_planes(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
