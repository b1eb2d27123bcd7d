#include "renderer/scene/gltf/tidy_animations.h"

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

struct PointedAt {
  int node = 0;
  std::string_view path;
};

/// "/nodes/3/rotation" as what it says, if it is of a node's own pose.
std::optional<PointedAt> node_pose(std::string_view pointer) {
  constexpr std::string_view prefix = "/nodes/";
  if (!pointer.starts_with(prefix)) return std::nullopt;
  pointer.remove_prefix(prefix.size());
  PointedAt at;
  const auto [end, error] =
      std::from_chars(pointer.data(), pointer.data() + pointer.size(), at.node);
  if (error != std::errc() || at.node < 0 || pointer.empty() || pointer.front() == '-')
    return std::nullopt;
  at.path = pointer.substr(static_cast<std::size_t>(end - pointer.data()));
  if (!at.path.starts_with('/')) return std::nullopt;
  at.path.remove_prefix(1);
  constexpr std::array<std::string_view, 4> paths{"translation", "rotation", "scale", "weights"};
  if (std::find(paths.begin(), paths.end(), at.path) == paths.end()) return std::nullopt;
  return at;
}

/// The pointer of a channel's target; empty where it has none.
std::string pointer_of(const json& target) {
  const auto extensions = target.find("extensions");
  if (extensions == target.end() || !extensions->is_object()) return {};
  const auto found = extensions->find(pointer_extension);
  if (found == extensions->end() || !found->is_object()) return {};
  const auto pointer = found->find("pointer");
  return pointer != found->end() && pointer->is_string() ? pointer->get<std::string>()
                                                         : std::string();
}

void resolve_pointer(json& target, const std::string& place, Warnings& warnings) {
  const std::string pointer = pointer_of(target);
  if (target.contains("node")) {
    warnings.add(place + ": it names a node and a pointer; the pointer holds");
    target.erase("node");
  }
  if (pointer.empty()) {
    warnings.add(place + ": its path is a pointer, which it does not have; ignored");
  } else if (const auto at = node_pose(pointer)) {
    target["node"] = at->node;
    target["path"] = std::string(at->path);
  } else {
    warnings.add(fmt::format("{}: it moves {}, which is not read; that stays as the file has it",
                             place, pointer));
  }
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
      if (target.contains("path") && target["path"] == "pointer")
        resolve_pointer(target, fmt::format("animation {}, channel {}", a, c), warnings);
      if (!target.contains("node")) target["node"] = -1;
    }
  }
}

}  // namespace asos::gltf
