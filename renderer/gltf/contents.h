#pragma once

#include "renderer/gltf/clips.h"
#include "renderer/gltf/document.h"
#include "renderer/scene/contents.h"

#include <vector>

namespace asos::gltf {

/// What the file holds; `shown` are the nodes of the scene that is shown.
[[nodiscard]] SceneContents contents_of(const Document& document, const std::vector<Clip>& clips,
                                        const std::vector<int>& shown, int shown_scene);

}  // namespace asos::gltf
