#pragma once

#include "renderer/gltf/document.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos::gltf {

/// Returns the light of a node by EXT_lights_area (Khronos PR #2525) or else KHR_lights_area (PR
/// #1948), placed in the world. Returns nullopt if there is none, or, with a warning, if it is
/// invalid.
[[nodiscard]] std::optional<Light> area_light(Document& document, const tinygltf::Node& node,
                                              const glm::dmat4& world_from_node);

/// Returns the light that a node's extras describe as "asos_light" (LIGHTS.md), likewise.
[[nodiscard]] std::optional<Light> extras_light(Document& document, const tinygltf::Node& node,
                                                const glm::dmat4& world_from_node);

/// Adds the node's area, linear or polygon light. A node with a light in both an extension and
/// extras has one light; if they differ, the extension is used.
void add_area_light(Document& document, const tinygltf::Node& node,
                    const glm::dmat4& world_from_node, Scene& scene);

}  // namespace asos::gltf
