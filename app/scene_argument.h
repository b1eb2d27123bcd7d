#pragma once

#include "renderer/gltf/load.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <string>

namespace CLI {
class App;
}

namespace asos {

/// Checks that there is something to open, without opening it. Errors are those of
/// open_scene_argument.
[[nodiscard]] Result<void> check_scene_argument(const std::string& text);

/// Opens the argument SCENE: a path, or "builtin:NAME". If the name is unknown or the file is
/// missing, the error lists the built-in scenes, the most similar first.
[[nodiscard]] Result<Scene> open_scene_argument(const std::string& text,
                                                const LoadOptions& options = {});

/// Makes the built-in scene called `name` ("office" or "builtin:office"), with its rig.
[[nodiscard]] Result<Scene> make_builtin_scene(const std::string& name);

/// Options of commands that open one scene: the scene of the file, the material variant, and the
/// asset root.
void add_scene_choices(CLI::App& app, std::string& scene, std::string& variant,
                       std::string& asset_root);

/// The option for the asset root, the folder that the scene's files may come from.
void add_asset_root_option(CLI::App& app, std::string& asset_root);

/// The positional argument SCENE. `required`: there is no default.
void add_scene_argument(CLI::App& app, std::string& scene, bool required);

}  // namespace asos
