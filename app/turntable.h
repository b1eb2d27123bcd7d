#pragma once

#include "renderer/result.h"
#include "renderer/scene/turned_camera.h"

#include <string>
#include <string_view>

namespace asos {

/// Frames `first` to `last` of a whole turn of `count` frames.
struct FrameRange {
  int first = 0;
  int last = 0;
  int count = 1;
};

/// The most frames of a turn.
inline constexpr int most_frames = 100'000;

/// "A-B/N", "A/N" for one frame, "N" for all: frames from 0 to N - 1.
[[nodiscard]] Result<FrameRange> parse_frames(std::string_view text);

/// "a/turn.png" of frame 7 of 120: "a/turn-007.png", so that names sort as frames do.
[[nodiscard]] std::string frame_path(const std::string& path, int frame, int count);
/// "a/walk.png" of frame 7 of an animation: "a/walk-0007.png".
[[nodiscard]] std::string clip_frame_path(const std::string& path, int frame);

}  // namespace asos
