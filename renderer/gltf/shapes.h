#pragma once

#include "renderer/gltf/document.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos::gltf {

/// Returns the analytic shape of a node (SHAPES.md): by its extension ASOS_implicit_shape, which
/// refers to KHR_implicit_shapes, or by `asos_shape` in its extras. Returns nullopt if it has none,
/// or, with a warning, if the description is invalid.
[[nodiscard]] std::optional<Shape> node_shape(Document& document, const tinygltf::Node& node);

}  // namespace asos::gltf
