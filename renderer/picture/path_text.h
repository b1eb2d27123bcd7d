#pragma once

#include <string>
#include <string_view>

namespace asos {

/// A path as text that JSON can hold: itself where it is UTF-8, else as a file: URI, so that paths,
/// which are bytes, come back as they were.
[[nodiscard]] std::string text_of_path(std::string_view path);

/// The path that such a text stands for.
[[nodiscard]] std::string path_of_text(std::string_view text);

}  // namespace asos
