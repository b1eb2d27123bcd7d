#pragma once

#include "renderer/gltf/document.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

namespace asos::gltf {

/// Adds the camera that a node refers to; an invalid camera is left out with a warning. The node's
/// scale is removed: glTF cameras are not scaled.
void add_camera(Document& document, const tinygltf::Node& node, const glm::dmat4& world_from_node,
                Scene& scene);

/// Adds the node's lights: the one of KHR_lights_punctual, which may have a size in extras, and the
/// area, linear or polygon light. An invalid light is left out with a warning. LIGHTS.md describes
/// the encodings.
void add_light(Document& document, const tinygltf::Node& node, const glm::dmat4& world_from_node,
               Scene& scene);

/// Returns which lighting the program adds to a scene of the document, as its extras say
/// (LIGHTS.md). An unknown value is ignored with a warning. `scene` -1: the file has no scenes.
[[nodiscard]] AddedLighting added_lighting(Document& document, int scene);

}  // namespace asos::gltf
