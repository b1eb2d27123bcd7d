#pragma once

#include "renderer/gltf/values.h"
#include "renderer/gltf/warnings.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

// Common functions for the encodings of lights (LIGHTS.md).

namespace asos::gltf {

inline bool positive(double value) {
  return std::isfinite(value) && value > 0.0;
}

/// Returns a bool, also from 0 or 1, to which some programs convert it when they save extras.
[[nodiscard]] std::optional<bool> on_or_off(const tinygltf::Value& object, const std::string& name);

/// Returns the property `name`, or `otherwise` if there is none. An error if it is no positive
/// number.
[[nodiscard]] Checked<double> positive_or(const tinygltf::Value& object, const std::string& name,
                                          double otherwise);

/// Returns the finite numbers of a list; nullopt if it is missing or has other entries.
[[nodiscard]] std::optional<std::vector<double>> numbers(const tinygltf::Value& object,
                                                         const std::string& name);

/// Sets intensity and colour. Returns why they are invalid, or an empty string.
[[nodiscard]] std::string set_brightness(double intensity, const std::vector<double>& color,
                                         Light& light);

/// Moves the intensity of a light that is switched off from its extras into its colour, which then
/// exceeds 1.
void read_off_intensity(const tinygltf::Value& extras, Light& light);

/// Sets intensity and colour from `object`'s properties "intensity" and "color", which is white by
/// default. With `default_intensity` nullopt, the intensity is required.
[[nodiscard]] std::string read_brightness(const tinygltf::Value& object,
                                          std::optional<double> default_intensity, Light& light);

/// Returns the largest component of the scale in `world_from_node`, by which lights' sizes are
/// multiplied.
[[nodiscard]] double largest_scale(const glm::dmat4& world_from_node);

/// The unit axes of a node, perpendicular even if its parents shear: the emitting direction (-Z),
/// across (X), and up (Y). Nullopt if the matrix is singular.
struct LightAxes {
  glm::dvec3 x, y, direction;
};
[[nodiscard]] std::optional<LightAxes> light_axes(const glm::dmat4& world_from_node);

}  // namespace asos::gltf
