#include "renderer/gltf/load.h"

#include "renderer/gltf/converted.h"
#include "renderer/scene/builtin.h"

#include <string_view>
#include <utility>

namespace asos {

namespace {

Result<Scene> load_builtin(const std::string& source, const std::string& name,
                           const LoadOptions& options) {
  if (!options.variant.empty())
    return unexpected(Error{source, "built-in scenes have no variants of their materials"});
  if (!options.scene.empty())
    return unexpected(Error{source, "built-in scenes have no other scenes to choose from"});
  Result<Scene> scene = builtin_scene(name);
  if (!scene) return unexpected(Error{source, std::move(scene.error().reason)});
  scene->source = source;
  if (!options.keep_posable) scene->rig = nullptr;
  return scene;
}

}  // namespace

Result<Scene> load_scene(const std::string& source, const LoadOptions& options) {
  constexpr std::string_view prefix = "builtin:";
  if (source.starts_with(prefix))
    return load_builtin(source, source.substr(prefix.size()), options);
  if (source.empty()) return unexpected(Error{"scene", "no file is named"});
  if (gltf::is_convertible(source)) return gltf::import_converted(source, options);
  return import_gltf(source, options);
}

}  // namespace asos
