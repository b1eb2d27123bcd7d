#pragma once

#include <string>
#include <string_view>

namespace asos {

/// Converts a path to text for JSON: unchanged if it is UTF-8, else as a file: URI, so that paths,
/// which are bytes, are read back unchanged.
[[nodiscard]] std::string text_of_path(std::string_view path);

/// Converts a text of text_of_path to its path.
[[nodiscard]] std::string path_of_text(std::string_view text);

}  // namespace asos
