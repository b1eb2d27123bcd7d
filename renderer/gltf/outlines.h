#pragma once

#include "renderer/gltf/warnings.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos::gltf {

using Outlines = std::vector<std::vector<glm::dvec3>>;

/// Largest number of corners in all outlines of a light.
inline constexpr std::size_t most_outline_corners = 2000;

/// A polygon light's shape, as in Light.
struct FlatOutlines {
  Outlines outlines;       ///< exactly flat; holes run opposite to the outer outline
  glm::dvec3 middle{0.0};  ///< mean of the outer outline's corners: a point of the plane
  glm::dvec3 normal{0.0};  ///< unit; the outer outline runs counter-clockwise around it
};

/// Flattens closed outlines to one plane. The first outline encloses the others. Errors, in words
/// that follow a light's name: a number that is not finite, fewer than three corners, no area,
/// corners farther from the plane than a thousandth of the extent, outlines that cross, holes that
/// are not inside.
[[nodiscard]] Checked<FlatOutlines> flatten_outlines(Outlines outlines);

}  // namespace asos::gltf
