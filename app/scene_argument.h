#pragma once

#include "renderer/gltf/load.h"
#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <string>

namespace CLI {
class App;
}

namespace asos {

/// Whether there is something to open, without opening it: the errors are those below.
[[nodiscard]] Result<void> check_scene_argument(const std::string& text);

/// Opens what was typed as SCENE: a path, or "builtin:NAME". The error of a name that is not known
/// or a file that is not there lists the built-in scenes, the likeliest first.
[[nodiscard]] Result<Scene> open_scene_argument(const std::string& text,
                                                const LoadOptions& options = {});

/// The built-in scene called `name` ("office" or "builtin:office").
[[nodiscard]] Result<Scene> make_builtin_scene(const std::string& name);

/// The options of a command that opens one scene: one of the file's scenes, one of its variants of
/// its materials, and its asset root.
void add_scene_choices(CLI::App& app, std::string& scene, std::string& variant,
                       std::string& asset_root);

/// The option for the folder that the scene's files may come from.
void add_asset_root_option(CLI::App& app, std::string& asset_root);

/// The positional argument SCENE. `required`: there is no default.
void add_scene_argument(CLI::App& app, std::string& scene, bool required);

}  // namespace asos
