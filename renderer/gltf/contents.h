#pragma once

#include "renderer/gltf/clips.h"
#include "renderer/gltf/document.h"
#include "renderer/gltf/nodes.h"
#include "renderer/scene/scene.h"

#include <vector>

namespace asos::gltf {

/// Lists the animations, scenes, variants and nodes of the document from which `scene` was
/// imported. `graph` and `shown_scene` are those of that import.
[[nodiscard]] SceneContents contents_of(const Document& document, const std::vector<Clip>& clips,
                                        const NodeGraph& graph, int shown_scene,
                                        const Scene& scene);

}  // namespace asos::gltf
