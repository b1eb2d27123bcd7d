#include "renderer/scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace asos {

namespace {

Result<Scene> load_builtin(const std::string& source, std::string_view name, bool keep_rig) {
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const BuiltinScene& s) { return s.name == name; });
  if (found == scenes.end()) {
    std::string names;
    for (const BuiltinScene& s : scenes) names += (names.empty() ? "" : ", ") + s.name;
    return unexpected(Error{source, "there is no such built-in scene; there are " + names});
  }
  Scene scene = found->make();
  scene.source = source;
  if (!keep_rig) scene.rig = nullptr;
  return scene;
}

}  // namespace

Result<Scene> load_scene(const std::string& source, const LoadOptions& options) {
  constexpr std::string_view prefix = "builtin:";
  if (source.starts_with(prefix)) {
    if (!options.variant.empty())
      return unexpected(Error{source, "built-in scenes have no variants of their materials"});
    if (!options.scene.empty())
      return unexpected(Error{source, "built-in scenes have no other scenes to choose from"});
    return load_builtin(source, std::string_view(source).substr(prefix.size()), options.keep_rig);
  }
  if (source.empty()) return unexpected(Error{"scene", "no file is named"});
  return import_gltf(source, options);
}

}  // namespace asos
