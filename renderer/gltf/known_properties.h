#pragma once

#include <string_view>

namespace asos::gltf {

/// Returns whether glTF has a property of that name in objects with the place `shape`, without the
/// numbers of entries ("/nodes"). Everything in extensions, extras and the asset counts as known.
[[nodiscard]] bool is_known_property(std::string_view name, std::string_view shape);

}  // namespace asos::gltf
