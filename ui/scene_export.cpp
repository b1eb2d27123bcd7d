#include "ui/scene_export.h"

#include "renderer/gltf/load.h"
#include "renderer/world/ground.h"
#include "ui/hidden_objects.h"
#include "ui/previewer.h"

#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

namespace asos::ui {

namespace {

std::vector<Light> moved(std::vector<Light> lights, glm::dvec3 by) {
  for (Light& light : lights) {
    light.position += by;
    light.own_part = -1;
    for (std::vector<glm::dvec3>& outline : light.outlines)
      for (glm::dvec3& corner : outline) corner += by;
  }
  return lights;
}

Result<void> check_path(const SceneOrder& order) {
  std::error_code ignored;
  if (std::filesystem::equivalent(order.path, order.source.path, ignored))
    return unexpected(Error{order.path, "is the open file; choose another name"});
  return {};
}

std::string words_of(const Scene& scene, const std::string& path) {
  return scene.contents.animations.empty() ? path : path + " (without its animations)";
}

Result<std::string> written(const SceneOrder& order) {
  Result<Scene> scene = load_scene(order.source.path, {.variant = order.source.variant,
                                                       .scene = order.source.scene,
                                                       .asset_root = order.source.asset_root});
  if (!scene) return unexpected(scene.error());
  leave_out(*scene, order.source.hidden);
  if (order.lights) scene->lights = *order.lights;
  if (order.dfrs)
    for (std::size_t i = 0; i < std::min(order.dfrs->size(), scene->materials.size()); ++i)
      scene->materials[i].dfr = (*order.dfrs)[i];
  return export_gltf(*scene, order.path).map([&] { return words_of(*scene, order.path); });
}

}  // namespace

SceneOrder order_of(const Previewer& previewer, std::string path) {
  const RenderScene& scene = *previewer.scene();
  const SceneEdits& edits = previewer.edits();
  SceneOrder order{previewer.scene().shown_source(), std::move(path), std::nullopt, std::nullopt};
  if (scene.lighting != scene.own_lighting)
    order.lights = moved(lights_on(edits.lights()), scene.world().origin);
  if (edits.dfrs() != dfrs_without_ground(scene.world())) order.dfrs = edits.dfrs();
  return order;
}

Result<std::string> export_edited(const SceneOrder& order) {
  if (const Result<void> sound = check_path(order); !sound) return unexpected(sound.error());
  // Running out of memory is reported as an error and does not end the program.
  try {
    return written(order);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{order.path, "not enough memory to write this scene"});
  }
}

}  // namespace asos::ui
