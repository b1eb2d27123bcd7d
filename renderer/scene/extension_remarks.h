#pragma once

#include <string>
#include <string_view>

namespace asos {

/// What a picture looks like that lacks a glTF extension; empty where that is not known.
[[nodiscard]] std::string_view seen_without(std::string_view extension);

/// A glTF extension that is not supported, in a line: its name, and what a picture without it looks
/// like where that is known.
[[nodiscard]] std::string unsupported_line(std::string_view extension);

}  // namespace asos
