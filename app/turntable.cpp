#include "app/turntable.h"

#include "renderer/settings/value_text.h"

#include <fmt/format.h>

#include <filesystem>

namespace asos {
namespace {

std::string numbered(const std::string& path, int frame, int digits) {
  const std::filesystem::path whole(path);
  std::filesystem::path named = whole.parent_path();
  named /=
      fmt::format("{}-{:0{}}{}", whole.stem().string(), frame, digits, whole.extension().string());
  return named.string();
}

}  // namespace

Result<FrameRange> parse_frames(std::string_view text) {
  const auto fault = [&](const char* reason) {
    return tl::unexpected(Error{fmt::format("\"{}\"", text), reason});
  };
  const std::size_t slash = text.find('/');
  const bool some = slash != std::string_view::npos;
  const auto count = parse_whole(some ? text.substr(slash + 1) : text, 1, most_frames);
  if (!count) return fault("is not A-B/N, A/N or N, a turn of N frames, from 1 to 100000");
  if (!some) return FrameRange{0, *count - 1, *count};
  const std::string_view range = text.substr(0, slash);
  const std::size_t dash = range.find('-');
  const auto first = parse_whole(range.substr(0, dash), 0, *count - 1);
  const auto last =
      dash == std::string_view::npos ? first : parse_whole(range.substr(dash + 1), 0, *count - 1);
  if (!first || !last) return fault("names a frame that is not from 0 to N - 1");
  if (*last < *first) return fault("ends before it begins");
  return FrameRange{*first, *last, *count};
}

std::string frame_path(const std::string& path, int frame, int count) {
  return numbered(path, frame, static_cast<int>(std::to_string(count - 1).size()));
}

std::string clip_frame_path(const std::string& path, int frame) {
  return numbered(path, frame, 4);
}

}  // namespace asos
