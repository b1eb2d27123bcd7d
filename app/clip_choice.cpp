#include "app/clip_choice.h"

#include "app/turntable.h"
#include "renderer/settings/value_text.h"

#include <fmt/format.h>

namespace asos {
namespace {

constexpr double most_fps = 1000.0;

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

}  // namespace asos
