#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace asos::gltf {

/// Faults: no asset version, a version other than 2, or an extension that the file requires and
/// that is not supported, by name. Returns the optional extensions that are not honoured.
[[nodiscard]] Checked<std::vector<std::string>> check_header(const nlohmann::json& root,
                                                             Warnings& warnings);

/// Makes a parsed document fit for tinygltf, which takes much on trust: drops `extras` (but a
/// light's `casts_shadows`) and unknown extensions, whose values would be copied many times over,
/// drops references that are not whole numbers and would wrap around, and moves each primitive's
/// `indices` among its attributes, since tinygltf refuses indices without a buffer view, which
/// Draco and sparse accessors have. Faults: offsets and lengths that are not
/// whole numbers, and more entries than `json_bytes` of text can mean to have, of which tinygltf
/// makes hundreds of times as much. Recursive: check the nesting depth first.
[[nodiscard]] Checked<void> tidy(nlohmann::json& root, std::size_t json_bytes, Warnings& warnings);

}  // namespace asos::gltf
