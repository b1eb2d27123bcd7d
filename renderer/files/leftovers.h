#pragma once

#include <filesystem>
#include <string_view>

namespace asos {

/// Removes what runs that were killed have left of a file on its way: the files of `folder` whose
/// names are `prefix`, the number of a process that is no more, and whatever follows.
void remove_leftovers(const std::filesystem::path& folder, std::string_view prefix);

}  // namespace asos
