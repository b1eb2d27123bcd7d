#pragma once

#include "renderer/scene/contents.h"

#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A line for each sort of thing of which a picture at `time` shows one, or none, and others are
/// there: what they are, and what is seen instead.
[[nodiscard]] std::vector<std::string> not_shown(const SceneContents& contents,
                                                 const std::optional<ClipTime>& time);

/// A line on the file's cameras that no picture is seen through, whatever is chosen; none: all are.
[[nodiscard]] std::optional<std::string> cameras_remark(const SceneContents& contents);

}  // namespace asos
