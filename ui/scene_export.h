#pragma once

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
  std::optional<std::vector<Light>> lights;  ///< author's coordinates; none: the file's
  std::optional<MaterialDfrs> dfrs;          ///< none: the file's own
};

/// The open scene with its edits. Requires a scene.
[[nodiscard]] SceneOrder order_of(const Previewer& previewer, std::string path);

/// Loads the scene again and writes it with the edits. Returns the path, and a message that lists
/// the unsupported parts. Errors name the file and the reason.
[[nodiscard]] Result<std::string> export_edited(const SceneOrder& order);

using SceneExportJob = StoppableJob<Result<std::string>>;

}  // namespace asos::ui
