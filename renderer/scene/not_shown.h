#pragma once

#include "renderer/scene/contents.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// Returns one line per kind of alternative (scenes, variants, animations) that a picture at `time`
/// does not show: the unused ones, and the one shown instead.
[[nodiscard]] std::vector<std::string> not_shown(const SceneContents& contents,
                                                 const std::optional<ClipTime>& time);

/// Returns a line on the cameras of the file that cannot be chosen as a view; none if all can.
[[nodiscard]] std::optional<std::string> cameras_remark(const SceneContents& contents);

}  // namespace asos
