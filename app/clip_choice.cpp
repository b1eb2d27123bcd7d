#include "app/clip_choice.h"

#include "app/turntable.h"
#include "app/values.h"
#include "renderer/files/printable.h"

#include <fmt/format.h>

namespace asos {
namespace {

constexpr double most_fps = 1000.0;

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

Result<ClipFrames> parse_clip_frames(std::string_view text) {
  const auto fault = [&](const char* reason) {
    return tl::unexpected(Error{fmt::format("\"{}\"", text), reason});
  };
  const std::size_t slash = text.find('/');
  const bool some = slash != std::string_view::npos;
  const auto fps = parse_number(some ? text.substr(slash + 1) : text, 0.0, most_fps, true);
  if (!fps)
    return fault(
        "is not A-B/FPS, A/FPS or FPS, frames of the animation, above 0 up to 1000 a "
        "second");
  ClipFrames frames{0, std::nullopt, *fps};
  if (!some) return frames;
  const std::string_view range = text.substr(0, slash);
  const std::size_t dash = range.find('-');
  const auto first = parse_whole(range.substr(0, dash), 0, most_frames);
  const auto last =
      dash == std::string_view::npos ? first : parse_whole(range.substr(dash + 1), 0, most_frames);
  if (!first || !last) return fault("names a frame that is not from 0 to 100000");
  if (*last < *first) return fault("ends before it begins");
  frames.first = *first;
  frames.last = *last;
  return frames;
}

Result<int> find_animation(const SceneContents& contents, const std::string& source,
                           const std::optional<std::string>& wanted) {
  const auto count = static_cast<int>(contents.animations.size());
  if (count == 0) return tl::unexpected(Error{source, "has no animations"});
  if (!wanted) return 0;
  for (int i = 0; i < count; ++i)
    if (contents.animations[static_cast<std::size_t>(i)].name == *wanted) return i;
  if (const auto number = parse_whole(*wanted, 0, count - 1)) return *number;
  return tl::unexpected(
      Error{source, fmt::format("has no animation \"{}\"; there {} {}", printable(*wanted),
                                count == 1 ? "is" : "are", animation_list(contents))});
}

}  // namespace asos
