#pragma once

#include "renderer/gltf/clips.h"
#include "renderer/gltf/document.h"
#include "renderer/gltf/nodes.h"
#include "renderer/scene/scene.h"

#include <vector>

namespace asos::gltf {

/// What the file holds beside `scene`, which was made of it. `graph` and `shown_scene`: those it
/// was made by.
[[nodiscard]] SceneContents contents_of(const Document& document, const std::vector<Clip>& clips,
                                        const NodeGraph& graph, int shown_scene,
                                        const Scene& scene);

}  // namespace asos::gltf
