#include "renderer/gltf/scene_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace asos::gltf {

namespace {

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::string scene_list(const std::vector<tinygltf::Scene>& scenes) {
  constexpr std::size_t most_listed = 32;
  std::string text;
  for (std::size_t i = 0; i < std::min(scenes.size(), most_listed); ++i) {
    const std::string& name = scenes[i].name;
    text += fmt::format("{}{}{}", i ? ", " : "", i, name.empty() ? "" : " ('" + name + "')");
  }
  if (scenes.size() > most_listed) text += fmt::format(" and {} more", scenes.size() - most_listed);
  return text;
}

}  // namespace

int default_scene(Document& document) {
  const auto count = static_cast<int>(document.model.scenes.size());
  const int named = document.model.defaultScene;
  if (count == 0) {
    if (!document.model.nodes.empty())
      document.warnings.add("has no scene; all its nodes are shown");
    return -1;
  }
  if (named >= count)
    document.warnings.add(
        fmt::format("its default scene {} does not exist; scene 0 takes its place", named));
  return named >= 0 && named < count ? named : 0;
}

Checked<int> find_scene(const Document& document, const std::string& wanted) {
  const std::vector<tinygltf::Scene>& scenes = document.model.scenes;
  // Every scene can also be selected with its number, even if it has a name.
  if (const auto number = whole_number(wanted); number && *number < scenes.size())
    return static_cast<int>(*number);
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const tinygltf::Scene& s) { return s.name == wanted; });
  if (found != scenes.end() && !wanted.empty()) return static_cast<int>(found - scenes.begin());
  if (scenes.empty()) return fault("has no scenes to choose from");
  return fault(fmt::format("has no scene '{}'; there {} {}", wanted,
                           scenes.size() == 1 ? "is" : "are", scene_list(scenes)));
}

}  // namespace asos::gltf
