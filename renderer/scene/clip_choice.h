#pragma once

#include "renderer/result.h"
#include "renderer/scene/contents.h"

#include <optional>
#include <string>

namespace asos {

/// The user's choice of a moment of a file's animations. An absent animation means the first one,
/// and an absent time its beginning. If both are absent, the scene is not animated.
struct ClipChoice {
  std::optional<std::string> animation;  ///< a name or a number
  std::optional<double> seconds;

  [[nodiscard]] bool any() const { return animation || seconds; }
};

/// Returns the animation of this name, or else of this number; without a choice, the first. The
/// subject of the error is `source`, and its reason lists the animations.
[[nodiscard]] Result<int> find_animation(const SceneContents& contents, const std::string& source,
                                         const std::optional<std::string>& wanted);

/// Returns the chosen moment; none if there is no choice. Errors: as find_animation.
[[nodiscard]] Result<std::optional<ClipTime>> clip_time(const SceneContents& contents,
                                                        const std::string& source,
                                                        const ClipChoice& choice);

}  // namespace asos
