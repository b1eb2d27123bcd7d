#include "renderer/scene/clip_choice.h"

#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <charconv>

namespace asos {
namespace {

std::string animation_list(const SceneContents& contents) {
  std::string list;
  for (std::size_t i = 0; i < contents.animations.size(); ++i) {
    const std::string& name = contents.animations[i].name;
    list += fmt::format("{}{}{}", i ? ", " : "", i,
                        name.empty() ? "" : " (\"" + printable(name) + "\")");
  }
  return list;
}

}  // namespace

Result<int> find_animation(const SceneContents& contents, const std::string& source,
                           const std::optional<std::string>& wanted) {
  const auto count = static_cast<int>(contents.animations.size());
  if (count == 0) return unexpected(Error{source, "has no animations"});
  if (!wanted) return 0;
  for (int i = 0; i < count; ++i)
    if (contents.animations[static_cast<std::size_t>(i)].name == *wanted) return i;
  int number = -1;
  const char* end = wanted->data() + wanted->size();
  const auto [parsed, fault] = std::from_chars(wanted->data(), end, number);
  if (fault == std::errc() && parsed == end && number >= 0 && number < count) return number;
  return unexpected(
      Error{source, fmt::format("has no animation \"{}\"; there {} {}", printable(*wanted),
                                count == 1 ? "is" : "are", animation_list(contents))});
}

Result<std::optional<ClipTime>> clip_time(const SceneContents& contents, const std::string& source,
                                          const ClipChoice& choice) {
  if (!choice.any()) return std::nullopt;
  const Result<int> animation = find_animation(contents, source, choice.animation);
  if (!animation) return unexpected(animation.error());
  return ClipTime{*animation, choice.seconds.value_or(0.0)};
}

}  // namespace asos
