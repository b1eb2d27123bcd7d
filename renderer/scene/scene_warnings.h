#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asos {

/// Returns the differences between a file and its pictures, as lines of text for the user: parts
/// that are not shown, or shown differently.
[[nodiscard]] std::vector<std::string> scene_warnings(const SceneNotes& notes);

/// Returns the number of remarks, including those that the last warning only counts.
[[nodiscard]] std::uint64_t count_warnings(const SceneNotes& notes);

}  // namespace asos
