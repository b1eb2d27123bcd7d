#pragma once

#include "renderer/result.h"
#include "renderer/scene/clip_choice.h"

#include <optional>
#include <string_view>

namespace asos {

/// Frames of an animation: frame F is F / fps seconds from its beginning.
struct ClipFrames {
  int first = 0;
  std::optional<int> last;  ///< none: the last frame within the animation
  double fps = 24.0;
};

/// "A-B/FPS", "A/FPS" for one frame, "FPS" for all.
[[nodiscard]] Result<ClipFrames> parse_clip_frames(std::string_view text);

}  // namespace asos
