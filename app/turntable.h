#pragma once

#include "renderer/result.h"
#include "renderer/scene/turned_camera.h"

#include <string>
#include <string_view>

namespace asos {

/// Frames `first` to `last` of a full turn of `count` frames.
struct FrameRange {
  int first = 0;
  int last = 0;
  int count = 1;
};

/// Maximum number of frames of a turn.
inline constexpr int most_frames = 100'000;

/// "A-B/N", "A/N" for one frame, "N" for all: frames from 0 to N - 1.
[[nodiscard]] Result<FrameRange> parse_frames(std::string_view text);

/// Path of a frame of a turntable: "a/turn.png" becomes "a/turn-007.png" for frame 7 of 120, so
/// that names sort like frames.
[[nodiscard]] std::string frame_path(const std::string& path, int frame, int count);
/// Path of a frame of an animation: "a/walk.png" becomes "a/walk-0007.png" for frame 7.
[[nodiscard]] std::string clip_frame_path(const std::string& path, int frame);

}  // namespace asos
