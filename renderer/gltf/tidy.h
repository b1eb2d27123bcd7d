#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Checks the version and the required extensions. Returns the unsupported optional extensions.
/// Faults: no asset version, a version other than 2, or a required extension that is not supported,
/// by name.
[[nodiscard]] Checked<std::vector<std::string>> check_header(const nlohmann::json& root,
                                                             Warnings& warnings);

/// Prepares a parsed document for tinygltf, which checks little. Faults: offsets and lengths that
/// are not whole numbers, and more entries than `json_bytes` of text justify, since tinygltf needs
/// hundreds of times their memory. Recursive: check the nesting depth first.
/// - Drops unused `extras` (tidy_extras) and unknown extensions, since tinygltf would copy their
/// values many times.
/// - Drops references that are not whole numbers, since they would wrap around.
/// - Moves each primitive's `indices` to its attributes, since tinygltf rejects indices without a
/// buffer view, as with Draco and sparse accessors.
[[nodiscard]] Checked<void> tidy(nlohmann::json& root, std::size_t json_bytes, Warnings& warnings);

}  // namespace asos::gltf
