#pragma once

#include <string>
#include <string_view>

namespace asos::gltf {

/// True for the extensions that the importer honours.
[[nodiscard]] bool supports_extension(std::string_view name);

/// Whether an extension that the importer honours does something in the `extensions` of the object
/// at `place` ("/nodes/3"), as its specification says; where it does nothing, that is a loss.
[[nodiscard]] bool belongs_at(std::string_view extension, std::string_view place);

/// "/nodes/3/extensions" as "/nodes/extensions"; the document itself is "/".
[[nodiscard]] std::string without_numbers(std::string_view place);

}  // namespace asos::gltf
