#pragma once

#include <nlohmann/json.hpp>

#include <string_view>

namespace asos::gltf {

/// Returns the kind that a property's value should have and does not, in words such as "a list of
/// numbers". Empty: the kind is right, or the property is unknown. `place` is that of its object,
/// as a JSON pointer. A property of a wrong kind counts as absent, so the user should be warned.
[[nodiscard]] std::string_view wrong_kind(std::string_view name, const nlohmann::json& value,
                                          std::string_view place);

/// Returns whether a value is a whole number; 3.0 is one.
[[nodiscard]] bool is_whole(const nlohmann::json& value);

}  // namespace asos::gltf
