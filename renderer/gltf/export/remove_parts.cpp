#include "renderer/gltf/export/gltf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace asos::exporting {

using nlohmann::json;

namespace {

/// Returns the element of one of the document's lists that is an object; null if there is none.
json* element_of(json& root, const char* list, const json& index) {
  const auto found = root.find(list);
  if (found == root.end() || !found->is_array() || !index.is_number_unsigned()) return nullptr;
  const auto at = index.get<std::uint64_t>();
  return at < found->size() && (*found)[at].is_object() ? &(*found)[at] : nullptr;
}

void remove_from(json& object, const char* group, const char* name) {
  const auto found = object.find(group);
  if (found == object.end() || !found->is_object()) return;
  found->erase(name);
  if (found->empty()) object.erase(found);
}

void remove_mesh(json& node) {
  for (const char* name : {"mesh", "skin", "weights"}) node.erase(name);
  remove_from(node, "extensions", "EXT_mesh_gpu_instancing");
}

void remove_shape(json& node) {
  remove_mesh(node);
  remove_from(node, "extensions", "ASOS_implicit_shape");
  remove_from(node, "extras", "asos_shape");
}

/// Makes meshes without some of their primitives, each once.
class SmallerMeshes {
 public:
  explicit SmallerMeshes(json& root) : root_(root) {}

  /// Returns the index of the smaller mesh, or null if nothing is left of it.
  json without(const json& mesh, const std::set<int>& primitives) {
    json* const whole = element_of(root_, "meshes", mesh);
    if (!whole) return mesh;
    const auto [made, is_new] = made_.try_emplace({mesh.get<std::uint64_t>(), primitives});
    if (!is_new) return made->second;
    json smaller = *whole;
    json& list = smaller["primitives"];
    json kept = json::array();
    for (std::size_t p = 0; p < list.size(); ++p)
      if (!primitives.contains(static_cast<int>(p))) kept.push_back(list[p]);
    if (kept.empty()) return made->second;
    list = std::move(kept);
    made->second = root_["meshes"].size();
    root_["meshes"].push_back(std::move(smaller));
    return made->second;
  }

 private:
  json& root_;
  std::map<std::pair<std::uint64_t, std::set<int>>, json> made_;
};

/// Removes the animation of morph weights of a node that has no mesh any more.
void remove_weight_channels(std::size_t number, json& root) {
  const std::string pointer = fmt::format("/nodes/{}/weights", number);
  const auto moves_weights = [&](const json& channel) {
    if (!channel.is_object() || !channel.contains("target")) return false;
    const json& target = channel["target"];
    const json path = target.value("path", json());
    if (path == json("weights")) return target.value("node", json()) == json(number);
    const json::json_pointer place("/extensions/KHR_animation_pointer/pointer");
    const json aim = target.contains(place) ? target[place] : json();
    return aim.is_string() && aim.get<std::string>().starts_with(pointer);
  };
  const auto animations = root.find("animations");
  if (animations == root.end() || !animations->is_array()) return;
  for (json& animation : *animations) {
    const auto channels = animation.is_object() ? animation.find("channels") : animation.end();
    if (!animation.is_object() || channels == animation.end() || !channels->is_array()) continue;
    json kept = json::array();
    for (json& channel : *channels)
      if (!moves_weights(channel)) kept.push_back(std::move(channel));
    *channels = std::move(kept);
  }
  // glTF has no animations without channels.
  json moving = json::array();
  for (json& animation : *animations)
    if (!animation.is_object() || !animation.contains("channels") || !animation["channels"].empty())
      moving.push_back(std::move(animation));
  *animations = std::move(moving);
  if (animations->empty()) root.erase(animations);
}

}  // namespace

void remove_parts(const NodeParts& parts, json& root) {
  SmallerMeshes smaller(root);
  for (const auto& [number, primitives] : parts) {
    json* const node = element_of(root, "nodes", number);
    if (!node) continue;
    if (primitives.contains(-1)) {
      remove_shape(*node);
    } else if (json mesh = smaller.without(node->value("mesh", json()), primitives);
               !mesh.is_null()) {
      (*node)["mesh"] = std::move(mesh);
      continue;
    } else {
      remove_mesh(*node);
    }
    remove_weight_channels(number, root);
  }
}

}  // namespace asos::exporting
