#pragma once

#include "renderer/gltf/nodes.h"
#include "renderer/scene/scene_preview.h"

#include <optional>
#include <vector>

namespace asos::gltf {

/// Returns the box of a document's scene by the bounds that its POSITION accessors declare, and its
/// first camera. Decodes no geometry and adds no warnings. Primitives without usable bounds are
/// left out; nullopt: there are no others. The bounds may be wrong, since files are not checked for
/// them. Morph targets do not count, and skinned meshes follow their first joint. `scene` -1: all
/// nodes.
[[nodiscard]] std::optional<ScenePreview> declared_size(Document& document, Accessors& accessors,
                                                        const std::vector<NodePose>& poses,
                                                        int scene);

}  // namespace asos::gltf
