#pragma once

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace asos::gltf {

/// Returns whether `names` contains `name`.
[[nodiscard]] bool is_one_of(std::string_view name, std::span<const std::string_view> names);

/// Removes unused extras of an object: only those of lights and shapes (LIGHTS.md, SHAPES.md),
/// lenses (lens.md) and defocusing ratios (MATERIALS.md) stay. `place` is the object's, as a JSON
/// pointer.
void tidy_extras(nlohmann::json& object, const std::string& place);

/// Writes whole numbers of EXT_lights_area, KHR_lights_area and KHR_implicit_shapes as real ones,
/// which tinygltf does not truncate.
void tidy_area_lights(nlohmann::json& root);

}  // namespace asos::gltf
