#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asos {

/// Returns the differences between a file and its pictures, as lines of text for the user: parts
/// that are not shown, or shown differently.
[[nodiscard]] std::vector<std::string> scene_warnings(const SceneNotes& notes);

/// Returns the number of warnings, including those that the last warning only counts.
[[nodiscard]] std::uint64_t count_warnings(const SceneNotes& notes);

/// Returns how a picture looks without a glTF extension; empty if unknown.
[[nodiscard]] std::string_view seen_without(std::string_view extension);

/// Returns a line about an unsupported glTF extension: its name, and how a picture looks without
/// it, if known.
[[nodiscard]] std::string unsupported_line(std::string_view extension);

}  // namespace asos
