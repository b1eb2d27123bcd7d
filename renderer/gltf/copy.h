#pragma once

#include "renderer/gltf/load.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A primitive of a node's mesh, or its shape.
struct NodePart {
  int node = 0;        ///< index into SceneContents::nodes
  int primitive = -1;  ///< -1: the shape
};

/// Edits to write into a copy of a glTF file.
struct GltfEdits {
  std::string asset_root{};                    ///< as in LoadOptions
  int scene = -1;                              ///< becomes the default one; -1: stays
  std::string variant{};                       ///< its materials become the default ones
  std::optional<std::vector<Light>> lights{};  ///< instead of the file's
  /// What is added to `lights`. Ignored without `lights`.
  AddedLighting added_lighting = AddedLighting::automatic;
  /// Indices into SceneContents::nodes; their emissive meshes emit no light.
  std::vector<int> light_nodes{};
  std::vector<NodePart> removed{};
  std::optional<std::vector<std::optional<Dfr>>> dfrs{};  ///< of the file's materials
};

/// Writes a copy of a glTF file with edits. Everything else stays as it is in the file: animations,
/// skins, cameras, extensions. The copy is self-contained: buffers and images are embedded, without
/// decoding them. Files that are missing stay missing. Errors: a file that is no readable glTF, one
/// that cannot be written.
[[nodiscard]] Result<void> copy_gltf(const std::string& source, const std::string& path,
                                     const GltfEdits& edits);

}  // namespace asos
