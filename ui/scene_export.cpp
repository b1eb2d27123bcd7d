#include "ui/scene_export.h"

#include "renderer/gltf/copy.h"
#include "renderer/gltf/load.h"
#include "renderer/world/ground.h"
#include "ui/hidden_objects.h"
#include "ui/previewer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <new>
#include <set>
#include <system_error>
#include <utility>

namespace asos::ui {

namespace {

/// The lights of each surface that emits.
using SurfaceLights = std::map<int, std::vector<Light>>;  // by part

SurfaceLights lights_of_surfaces(const std::vector<EditedLight>& lights) {
  SurfaceLights by_part;
  for (const EditedLight& edited : lights)
    if (edited.light.own_part >= 0) by_part[edited.light.own_part].push_back(stored_light(edited));
  return by_part;
}

/// The node of a part; a number of its own if the scene has no nodes.
int emitting_node(const SceneContents& contents, int part, const std::vector<int>& hidden) {
  const auto object = static_cast<std::size_t>(place_among_all(part, hidden));
  if (object >= contents.object_nodes.size()) return -1 - part;
  const int node = contents.object_nodes[object];
  return node < 0 ? -1 - part : node;
}

/// The nodes that have a surface with edited lights. Marks in a file concern a whole node.
std::set<int> nodes_with_edited_lights(const RenderScene& scene, const SceneEdits& edits,
                                       const std::vector<int>& hidden) {
  const SurfaceLights before = lights_of_surfaces(edits.opened_lights());
  const SurfaceLights now = lights_of_surfaces(edits.lights());
  std::set<int> nodes;
  for (const auto& [part, lights] : before) {
    const auto found = now.find(part);
    if (found == now.end() || found->second != lights)
      nodes.insert(emitting_node(scene.geometry->contents, part, hidden));
  }
  return nodes;
}

Light turned_over(Light light) {
  light.direction = -light.direction;
  for (std::vector<glm::dvec3>& outline : light.outlines)
    std::reverse(outline.begin(), outline.end());
  return light;
}

/// Adds the light of a surface as one of its own: slightly in front of the surface, which would
/// occlude it.
void add_in_front(Light light, std::vector<Light>& lights) {
  constexpr double gap = 1e-3;
  light.own_part = -1;
  const double area = area_of(light);
  if (!(area > 0.0)) {
    light.radius *= 1.0 + gap;
    lights.push_back(std::move(light));
    return;
  }
  const bool both = std::exchange(light.two_sided, false);
  for (Light side : {light, turned_over(light)}) {
    if (!both && side.direction != light.direction) continue;
    move_light(side, gap * std::sqrt(area) * side.direction);
    lights.push_back(std::move(side));
  }
}

void take_lights(const Previewer& previewer, SceneOrder& order) {
  const RenderScene& scene = *previewer.scene();
  // Default lights are among the scene's own now, whether they are on or off.
  order.added_lighting =
      scene.geometry->stage.has_default_lighting ? AddedLighting::environment : AddedLighting::none;
  const SceneContents& contents = scene.geometry->contents;
  const std::vector<int>& hidden = previewer.scene().hidden();
  const std::set<int> nodes = nodes_with_edited_lights(scene, previewer.edits(), hidden);
  const auto replaced = [&](int part) {
    return nodes.contains(emitting_node(contents, part, hidden));
  };
  std::vector<Light>& lights = order.lights.emplace();
  for (const EditedLight& edited : previewer.edits().lights()) {
    Light light = stored_light(edited);
    move_light(light, scene.world().origin);
    if (light.own_part < 0)
      lights.push_back(std::move(light));
    else if (replaced(light.own_part))
      add_in_front(std::move(light), lights);
  }
  const std::vector<ObjectId> objects = previewer.scene().objects();
  for (int part = 0; part < static_cast<int>(scene.world().parts.size()); ++part)
    if (replaced(part))
      order.light_objects.push_back(
          objects.at(static_cast<std::size_t>(place_among_all(part, hidden))));
  for (const int node : nodes)
    if (node >= 0) order.light_nodes.push_back(node);
}

/// Returns the parts of the file's nodes that are hidden; none if hidden objects are not whole
/// parts: some copies of a node's mesh only.
std::optional<std::vector<NodePart>> hidden_parts(const std::vector<ObjectId>& hidden) {
  std::map<std::pair<int, int>, int> counts;
  for (const ObjectId& object : hidden) ++counts[{object.node, object.primitive}];
  std::vector<NodePart> parts;
  for (const ObjectId& object : hidden) {
    const int count = counts.at({object.node, object.primitive});
    if (object.node < 0 || count < object.copies) return std::nullopt;
    if (object.copy == 0) parts.push_back({object.node, object.primitive});
  }
  return parts;
}

Result<void> check_path(const SceneOrder& order) {
  std::error_code ignored;
  if (std::filesystem::equivalent(order.path, order.source.path, ignored))
    return unexpected(Error{order.path, "is the open file; choose another name"});
  return {};
}

bool is_builtin(const SceneOrder& order) {
  return order.source.path.starts_with("builtin:");
}

/// Whether the file can be copied, instead of writing the scene anew from its meshes at rest.
bool copies_file(const SceneOrder& order) {
  return !is_builtin(order) && order.removed;
}

Result<std::string> copied(const SceneOrder& order) {
  const GltfEdits edits{
      order.source.asset_root, order.shown_scene, order.source.variant, order.lights,
      order.added_lighting,    order.light_nodes, *order.removed,       order.dfrs};
  return copy_gltf(order.source.path, order.path, edits).map([&] { return order.path; });
}

std::string words_of(const Scene& scene, const std::string& path) {
  const bool complete = scene.contents.animations.empty() || writes_animations(scene);
  return complete ? path : path + " (without its animations)";
}

Result<std::string> written(const SceneOrder& order) {
  if (copies_file(order)) return copied(order);
  // Built-in scenes are quickly posed; the motion of a file's scene is seldom that of whole
  // objects.
  Result<Scene> scene = load_scene(order.source.path, {.keep_posable = is_builtin(order),
                                                       .variant = order.source.variant,
                                                       .scene = order.source.scene,
                                                       .asset_root = order.source.asset_root});
  if (!scene) return unexpected(scene.error());
  mark_as_lights(*scene, order.light_objects);
  leave_out(*scene, order.source.hidden);
  if (order.lights) {
    scene->lights = *order.lights;
    scene->added_lighting = order.added_lighting;
  }
  if (order.dfrs)
    for (std::size_t i = 0; i < std::min(order.dfrs->size(), scene->materials.size()); ++i)
      scene->materials[i].dfr = (*order.dfrs)[i];
  return export_gltf(*scene, order.path).map([&] { return words_of(*scene, order.path); });
}

}  // namespace

SceneOrder order_of(const Previewer& previewer, std::string path) {
  const RenderScene& scene = *previewer.scene();
  const SceneEdits& edits = previewer.edits();
  SceneOrder order;
  order.source = previewer.scene().shown_source();
  order.path = std::move(path);
  order.shown_scene = scene.geometry->contents.shown_scene;
  order.removed = hidden_parts(order.source.hidden);
  if (scene.lighting != scene.own_lighting) take_lights(previewer, order);
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
