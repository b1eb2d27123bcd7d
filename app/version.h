#pragma once

#include <string>

namespace asos {

/// Returns the lines that `asos --version` prints: version, commit, compiler and features.
[[nodiscard]] std::string version_text();

}  // namespace asos
