#pragma once

#include <string>
#include <string_view>

namespace asos::gltf {

/// Returns true for the extensions that the importer supports.
[[nodiscard]] bool supports_extension(std::string_view name);

/// Returns whether a supported extension has an effect in the `extensions` of the object at `place`
/// ("/nodes/3"), by its specification. Otherwise, its content is lost.
[[nodiscard]] bool belongs_at(std::string_view extension, std::string_view place);

/// Converts "/nodes/3/extensions" to "/nodes/extensions"; the document itself is "/".
[[nodiscard]] std::string without_numbers(std::string_view place);

}  // namespace asos::gltf
