#pragma once

#include <string_view>

namespace asos::gltf {

/// Whether glTF knows a property of that name in the object whose place, without the numbers of
/// entries, is `shape` ("/nodes"). What extensions, extras and the asset hold is not judged: all of
/// it is known.
[[nodiscard]] bool is_known_property(std::string_view name, std::string_view shape);

}  // namespace asos::gltf
