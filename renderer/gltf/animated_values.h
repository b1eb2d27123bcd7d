#pragma once

#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Values besides nodes that KHR_animation_pointer moves: numbers of materials, cameras and punctual
// lights, as in glTF's object model.

namespace asos::gltf {

/// Returns how many numbers the property at a pointer has; nullopt: it is not movable.
[[nodiscard]] std::optional<int> movable_numbers(std::string_view pointer);

/// Returns whether the object that contains the property exists.
[[nodiscard]] bool has_object_of(const nlohmann::json& root, std::string_view pointer);

/// Returns the index of the material that a pointer points into.
[[nodiscard]] std::optional<std::size_t> material_of(std::string_view pointer);

/// Returns a document's movable parts: materials, cameras and punctual lights.
[[nodiscard]] nlohmann::json movable_parts(const nlohmann::json& root);

struct AnimatedValue {
  std::string pointer;          ///< of a movable property in an existing object
  std::vector<double> numbers;  ///< one per component of the property
};

/// Replaces the model's materials, cameras and punctual lights by those of `parts` with `values`.
/// Fails as tinygltf does.
[[nodiscard]] Checked<void> set_values(nlohmann::json parts,
                                       const std::vector<AnimatedValue>& values,
                                       tinygltf::Model& model);

}  // namespace asos::gltf
