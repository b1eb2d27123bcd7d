#pragma once

#include <nlohmann/json.hpp>

#include <string_view>

namespace asos::gltf {

/// What a property's value has to be and is not, in words such as "a list of numbers"; empty: it is
/// of its kind, or the property is unknown. `place`: of the object that has it, as a JSON pointer.
/// A property that is of another kind is taken for absent, which a reader of the file should know.
[[nodiscard]] std::string_view wrong_kind(std::string_view name, const nlohmann::json& value,
                                          std::string_view place);

/// The same for a property whose value is to be a whole number; 3.0 is one.
[[nodiscard]] bool is_whole(const nlohmann::json& value);

}  // namespace asos::gltf
