#pragma once

#include "renderer/gltf/document.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos::gltf {

/// The analytic shape that a node is (SHAPES.md): by its extension ASOS_implicit_shape, which
/// refers to KHR_implicit_shapes, or by `asos_shape` in its extras. Nullopt where it is none, and,
/// with a warning, where its description is not valid.
[[nodiscard]] std::optional<Shape> node_shape(Document& document, const tinygltf::Node& node);

}  // namespace asos::gltf
