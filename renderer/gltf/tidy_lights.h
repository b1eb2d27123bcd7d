#pragma once

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace asos::gltf {

/// Whether `names` holds `name`.
[[nodiscard]] bool is_one_of(std::string_view name, std::span<const std::string_view> names);

/// Takes out of an object's extras what is not read: of all that applications put there, only what
/// concerns lights (LIGHTS.md) and the blur of reflections (MATERIALS.md) stays. `place`: the
/// object's, as a JSON pointer.
void tidy_extras(nlohmann::json& object, const std::string& place);

/// Writes the numbers of EXT_lights_area and KHR_lights_area so that none is taken for an index.
void tidy_area_lights(nlohmann::json& root);

}  // namespace asos::gltf
