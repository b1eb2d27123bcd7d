#pragma once

#include <filesystem>
#include <string_view>

namespace asos {

/// Removes temporary files of killed runs: the files in `folder` whose names are `prefix`, the
/// number of a process that no longer exists, and any suffix.
void remove_leftovers(const std::filesystem::path& folder, std::string_view prefix);

}  // namespace asos
