#pragma once

#include "renderer/result.h"
#include "renderer/scene/contents.h"

#include <optional>
#include <string>
#include <string_view>

namespace asos {

/// The moment of a file's animations that the command line asks for: of the first one, and of its
/// beginning, where it does not say; of none where it says neither.
struct ClipChoice {
  std::optional<std::string> animation;  ///< a name or a number
  std::optional<double> seconds;

  [[nodiscard]] bool any() const { return animation || seconds; }
};

/// Frames of an animation: frame F is F / fps seconds from its beginning.
struct ClipFrames {
  int first = 0;
  std::optional<int> last;  ///< none: the last one before the animation ends
  double fps = 24.0;
};

/// "A-B/FPS", "A/FPS" for one frame, "FPS" for all.
[[nodiscard]] Result<ClipFrames> parse_clip_frames(std::string_view text);

/// The animation of this name, or else of this number; none: the first. The error's subject is
/// `source`, and it lists what there is.
[[nodiscard]] Result<int> find_animation(const SceneContents& contents, const std::string& source,
                                         const std::optional<std::string>& wanted);

}  // namespace asos
