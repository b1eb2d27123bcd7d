#pragma once

#include "renderer/gltf/document.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos::gltf {

/// The light that a node has by EXT_lights_area (Khronos PR #2525) or else KHR_lights_area
/// (PR #1948), placed in the world; nullopt where there is none, or with a warning where it is not
/// valid.
[[nodiscard]] std::optional<Light> area_light(Document& document, const tinygltf::Node& node,
                                              const glm::dmat4& world_from_node);

/// The light that a node's extras describe under "asos_light" (LIGHTS.md), likewise.
[[nodiscard]] std::optional<Light> extras_light(Document& document, const tinygltf::Node& node,
                                                const glm::dmat4& world_from_node);

/// Adds the node's area, linear or polygon light. A node that describes one by an extension and in
/// extras has one light: where the two differ, the extension holds.
void add_area_light(Document& document, const tinygltf::Node& node,
                    const glm::dmat4& world_from_node, Scene& scene);

}  // namespace asos::gltf
