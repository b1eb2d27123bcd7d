#pragma once

#include <filesystem>

namespace asos {

/// The file that writing to `path` makes or replaces: symbolic links are followed, those to files
/// that do not exist included, so that a link stays a link. `path` itself where it is none, or
/// where links lead in a circle.
[[nodiscard]] std::filesystem::path followed_links(const std::filesystem::path& path);

}  // namespace asos
