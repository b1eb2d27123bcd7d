#pragma once

#include <string>
#include <vector>

namespace asos {

/// The files that a scene is read from, there or not: `source` itself first, then the buffers and
/// images that a glTF file names in its folder. None for a built-in scene; `source` alone where it
/// cannot be read as glTF. Any thread.
[[nodiscard]] std::vector<std::string> source_files(const std::string& source);

}  // namespace asos
