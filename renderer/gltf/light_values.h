#pragma once

#include "renderer/gltf/values.h"
#include "renderer/gltf/warnings.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

// Functions that the encodings of lights (LIGHTS.md) have in common.

namespace asos::gltf {

inline bool positive(double value) {
  return std::isfinite(value) && value > 0.0;
}

/// A bool, or the 0 or 1 that some programs make of one when they save extras.
[[nodiscard]] std::optional<bool> on_or_off(const tinygltf::Value& object, const std::string& name);

/// The property `name`: `otherwise` where there is none, an error where it is anything else than a
/// positive number.
[[nodiscard]] Checked<double> positive_or(const tinygltf::Value& object, const std::string& name,
                                          double otherwise);

/// The finite numbers of a list; nullopt where it is missing or holds anything else.
[[nodiscard]] std::optional<std::vector<double>> numbers(const tinygltf::Value& object,
                                                         const std::string& name);

/// Sets intensity and colour; says why they are not those of a light, or nothing.
[[nodiscard]] std::string set_brightness(double intensity, const std::vector<double>& color,
                                         Light& light);

/// The same from `object`'s properties "intensity" and "color", which is white by default.
/// `default_intensity` nullopt: it has to be there.
[[nodiscard]] std::string read_brightness(const tinygltf::Value& object,
                                          std::optional<double> default_intensity, Light& light);

/// The largest component of the scale in `world_from_node`, which lights' sizes are multiplied by.
[[nodiscard]] double largest_scale(const glm::dmat4& world_from_node);

/// The unit axes of a node, at right angles whatever shear its parents make: the way it shines
/// (-Z), then across (X), then up (Y). Nullopt where the matrix squeezes it flat.
struct LightAxes {
  glm::dvec3 x, y, direction;
};
[[nodiscard]] std::optional<LightAxes> light_axes(const glm::dmat4& world_from_node);

}  // namespace asos::gltf
