#pragma once

#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What KHR_animation_pointer moves beside nodes: numbers of materials, cameras and punctual lights,
// as glTF's object model lists them.

namespace asos::gltf {

/// How many numbers the property has that a pointer aims at; nullopt: not one of these.
[[nodiscard]] std::optional<int> movable_numbers(std::string_view pointer);

/// Whether the object in which that property stands is there.
[[nodiscard]] bool has_object_of(const nlohmann::json& root, std::string_view pointer);

/// The number of the material that a pointer aims into.
[[nodiscard]] std::optional<std::size_t> material_of(std::string_view pointer);

/// The parts of a document that these pointers aim into.
[[nodiscard]] nlohmann::json movable_parts(const nlohmann::json& root);

struct MovedValue {
  std::string pointer;          ///< of a movable property, whose object is there
  std::vector<double> numbers;  ///< as many as it has
};

/// Replaces the model's materials, cameras and punctual lights by those of `parts` with `values`.
/// Fails as tinygltf does.
[[nodiscard]] Checked<void> set_values(nlohmann::json parts, const std::vector<MovedValue>& values,
                                       tinygltf::Model& model);

}  // namespace asos::gltf
