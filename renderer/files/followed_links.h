#pragma once

#include <filesystem>

namespace asos {

/// Returns the file that a write to `path` creates or replaces. Follows symbolic links, even to
/// files that do not exist, so that a link stays a link. Returns `path` itself if it is no link, or
/// if links form a circle.
[[nodiscard]] std::filesystem::path followed_links(const std::filesystem::path& path);

}  // namespace asos
