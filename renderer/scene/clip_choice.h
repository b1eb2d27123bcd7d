#pragma once

#include "renderer/result.h"
#include "renderer/scene/contents.h"

#include <optional>
#include <string>

namespace asos {

/// The moment of a file's animations that somebody asks for: of the first one, and of its
/// beginning, where they do not say; of none where they say neither.
struct ClipChoice {
  std::optional<std::string> animation;  ///< a name or a number
  std::optional<double> seconds;

  [[nodiscard]] bool any() const { return animation || seconds; }
};

/// The animation of this name, or else of this number; none: the first. The error's subject is
/// `source`, and it lists what there is.
[[nodiscard]] Result<int> find_animation(const SceneContents& contents, const std::string& source,
                                         const std::optional<std::string>& wanted);

/// The moment that is asked for; none where nothing is. Errors: find_animation's.
[[nodiscard]] Result<std::optional<ClipTime>> clip_time(const SceneContents& contents,
                                                        const std::string& source,
                                                        const ClipChoice& choice);

}  // namespace asos
