#include "renderer/scene/not_shown.h"

#include "renderer/files/counted.h"

#include <fmt/format.h>

namespace asos {

namespace {

// Number of names listed in a line; the rest are only counted.
constexpr std::size_t most_names = 8;

/// Returns a list like "'Walk', 'Run'". Unnamed entries are listed by number.
std::string listed(const std::vector<std::string>& names, int without = -1) {
  std::string text;
  std::size_t told = 0, more = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (static_cast<int>(i) == without) continue;
    if (told == most_names) {
      ++more;
      continue;
    }
    const std::string name = names[i].empty() ? std::to_string(i) : "'" + names[i] + "'";
    text += (told++ ? ", " : "") + name;
  }
  return more ? fmt::format("{} and {} more", text, more) : text;
}

std::string scenes_line(const SceneContents& contents) {
  const std::string one = listed({contents.scenes[static_cast<std::size_t>(contents.shown_scene)]});
  const std::string shown = one == "0" ? std::to_string(contents.shown_scene) : one;
  const std::size_t others = contents.scenes.size() - 1;
  return fmt::format(
      "{} of the file {} not shown: {}; the picture is of scene {} (--scene "
      "shows another)",
      counted(others, "other scene", "other scenes"), others == 1 ? "is" : "are",
      listed(contents.scenes, contents.shown_scene), shown);
}

}  // namespace

std::vector<std::string> not_shown(const SceneContents& contents,
                                   const std::optional<ClipTime>& time) {
  std::vector<std::string> lines;
  if (!time && !contents.animations.empty()) {
    std::vector<std::string> names;
    for (const SceneContents::Animation& animation : contents.animations)
      names.push_back(animation.name);
    lines.push_back(
        fmt::format("{} not played: {}; everything stands where the file's nodes place it",
                    counted(names.size(), "animation is", "animations are"), listed(names)));
  }
  if (contents.shown_scene >= 0 && contents.scenes.size() > 1)
    lines.push_back(scenes_line(contents));
  if (!contents.variants.empty() && contents.variant.empty())
    lines.push_back(fmt::format("{} not shown: {}; materials are as without (--variant shows one)",
                                counted(contents.variants.size(), "variant is", "variants are"),
                                listed(contents.variants)));
  return lines;
}

std::optional<std::string> cameras_remark(const SceneContents& contents) {
  if (contents.cameras_not_placed == 0) return std::nullopt;
  return fmt::format("{} in no node that is shown and cannot be looked through",
                     counted(contents.cameras_not_placed, "camera is", "cameras are"));
}

}  // namespace asos
