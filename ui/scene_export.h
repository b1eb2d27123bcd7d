#pragma once

#include "renderer/gltf/copy.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"
#include "ui/scene_loader.h"
#include "ui/stoppable_job.h"

#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

class Previewer;

/// A scene to export as glTF with its edits.
struct SceneOrder {
  SceneSource source;
  std::string path;                          ///< .glb or .gltf
  int shown_scene = -1;                      ///< of the file; -1: it has none
  std::optional<std::vector<Light>> lights;  ///< author's coordinates; none: the file's
  AddedLighting added_lighting = AddedLighting::automatic;  ///< if there are `lights`
  /// The objects whose emissive surfaces are among `lights`, and their nodes: indices into
  /// SceneContents::nodes.
  std::vector<ObjectId> light_objects;
  std::vector<int> light_nodes;
  /// The hidden parts of the file's nodes; none: they cannot be removed from the file.
  std::optional<std::vector<NodePart>> removed;
  std::optional<MaterialDfrs> dfrs;  ///< none: the file's own
};

/// The open scene with its edits. Requires a scene.
[[nodiscard]] SceneOrder order_of(const Previewer& previewer, std::string path);

/// Copies the scene's file with the edits and without the hidden objects. A built-in scene is
/// written with its animations. If only some copies of an instanced node are hidden, a file is
/// written from its meshes at rest. Returns the path, with a note if animations were left out.
/// Errors name the file and the reason.
[[nodiscard]] Result<std::string> export_edited(const SceneOrder& order);

using SceneExportJob = StoppableJob<Result<std::string>>;

}  // namespace asos::ui
