#pragma once

#include "renderer/scene/builtin/stage.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <string>

// Surfaces of which a texture's alpha cuts out the most, for the built-in scenes. The images are
// made by code, the same every time; their alpha is 1/2 along the shapes' outlines and grows by
// their distance, so that the outlines are as smooth as the shapes.

namespace asos::builtin {

/// A square of wrought iron: bars on its left and upper side, a ring and a lozenge between.
/// Repeats.
[[nodiscard]] Image wrought_iron();

/// A twig that grows from the middle of the lower side upwards, with leaves on both sides.
[[nodiscard]] Image twig();

/// A double-sided material that shows an image where its alpha is at least 1/2; `wrap`: beyond its
/// sides.
int paint_cut_out(Stage& stage, const std::string& name, Image image, Wrap wrap);

/// Appends a parallelogram with texture coordinates: from `uv_lo` at `corner`, where the image's
/// upper left is, to `uv_hi` across.
void add_card(Mesh& mesh, glm::vec3 corner, glm::vec3 right, glm::vec3 down,
              glm::vec2 uv_lo = {0.0f, 0.0f}, glm::vec2 uv_hi = {1.0f, 1.0f});

}  // namespace asos::builtin
