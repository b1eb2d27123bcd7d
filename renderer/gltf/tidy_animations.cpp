#include "renderer/gltf/tidy_animations.h"

#include "renderer/gltf/animated_values.h"
#include "renderer/gltf/tidy_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace asos::gltf {

using nlohmann::json;

namespace {

constexpr const char* pointer_extension = "KHR_animation_pointer";

constexpr auto core_paths =
    std::to_array<std::string_view>({"translation", "rotation", "scale", "weights"});
constexpr std::string_view visibility = "extensions/KHR_node_visibility/visible";
constexpr std::string_view weights = "weights/";

struct PointedNode {
  int node = 0;
  std::string_view path;
  bool core = false;  ///< one of glTF's own paths
};

/// Parses "/nodes/3/rotation" and the like, if it is a part of a node's own pose or its visibility.
std::optional<PointedNode> node_pose(std::string_view pointer) {
  constexpr std::string_view prefix = "/nodes/";
  if (!pointer.starts_with(prefix)) return std::nullopt;
  pointer.remove_prefix(prefix.size());
  PointedNode at;
  const auto [end, error] =
      std::from_chars(pointer.data(), pointer.data() + pointer.size(), at.node);
  if (error != std::errc() || at.node < 0 || pointer.empty() || pointer.front() == '-')
    return std::nullopt;
  at.path = pointer.substr(static_cast<std::size_t>(end - pointer.data()));
  if (!at.path.starts_with('/')) return std::nullopt;
  at.path.remove_prefix(1);
  at.core = is_one_of(at.path, core_paths);
  if (at.core || at.path == visibility || at.path.starts_with(weights)) return at;
  return std::nullopt;
}

/// Returns the pointer of a channel's target; empty if it has none.
std::string pointer_of(const json& target) {
  const auto extensions = target.find("extensions");
  if (extensions == target.end() || !extensions->is_object()) return {};
  const auto found = extensions->find(pointer_extension);
  if (found == extensions->end() || !found->is_object()) return {};
  const auto pointer = found->find("pointer");
  return pointer != found->end() && pointer->is_string() ? pointer->get<std::string>()
                                                         : std::string();
}

bool is_pointer(const json& target) {
  return target.is_object() && target.contains("path") && target["path"] == "pointer";
}

/// Resolves pointers to glTF's own paths. Other supported pointers stay the same, for `read_clips`.
void resolve_pointer(const json& root, json& target, const std::string& place, Warnings& warnings) {
  const std::string pointer = pointer_of(target);
  if (target.contains("node")) {
    warnings.add(place + ": it names a node and a pointer; the pointer holds");
    target.erase("node");
  }
  if (pointer.empty()) {
    warnings.add(place + ": its path is a pointer, which it does not have; ignored");
  } else if (const auto at = node_pose(pointer)) {
    target["node"] = at->node;
    if (!at->core) return;
    target["path"] = std::string(at->path);
  } else if (movable_numbers(pointer) && has_object_of(root, pointer)) {
    return;
  } else {
    const bool known = movable_numbers(pointer).has_value();
    warnings.add(fmt::format("{}: it moves {}, which {}; that stays as the file has it", place,
                             pointer, known ? "the file does not have" : "is not read"));
  }
  target.erase("extensions");
}

}  // namespace

void tidy_animations(json& root, Warnings& warnings) {
  const auto animations = root.find("animations");
  if (animations == root.end() || !animations->is_array()) return;
  for (std::size_t a = 0; a < animations->size(); ++a) {
    json& animation = (*animations)[a];
    if (!animation.is_object()) continue;
    const auto channels = animation.find("channels");
    if (channels == animation.end() || !channels->is_array()) continue;
    for (std::size_t c = 0; c < channels->size(); ++c) {
      json& channel = (*channels)[c];
      if (!channel.is_object() || !channel.contains("target")) continue;
      json& target = channel["target"];
      if (!target.is_object()) continue;
      if (is_pointer(target))
        resolve_pointer(root, target, fmt::format("animation {}, channel {}", a, c), warnings);
      if (!target.contains("node")) target["node"] = -1;
    }
  }
}

bool moves_values(const json& root) {
  const auto animations = root.find("animations");
  if (animations == root.end() || !animations->is_array()) return false;
  for (const json& animation : *animations) {
    if (!animation.is_object() || !animation.contains("channels")) continue;
    for (const json& channel : animation["channels"]) {
      if (!channel.is_object() || !channel.contains("target")) continue;
      const json& target = channel["target"];
      if (is_pointer(target) && movable_numbers(pointer_of(target))) return true;
    }
  }
  return false;
}

}  // namespace asos::gltf
