#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asos {

/// What of a file is not in its pictures, or otherwise than it says there: a person should know
/// these before trusting one. Lines that may be shown.
[[nodiscard]] std::vector<std::string> remarks(const SceneNotes& notes);

/// How many remarks there are, with those that the last line of the warnings only counts.
[[nodiscard]] std::uint64_t remark_count(const SceneNotes& notes);

}  // namespace asos
