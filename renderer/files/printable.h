#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asos {

/// Returns text from outside (names, paths, file contents) in a form that is safe to display: one
/// line of valid UTF-8 that a terminal only prints. Control characters, line separators, direction
/// marks and invalid bytes become escapes such as
/// , \x1b and \u{202e}. Everything else stays the same, including existing escapes.
[[nodiscard]] std::string printable(std::string_view text);

/// Returns the length in bytes of the UTF-8 character at the start of `text`, or 0 if there is
/// none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Returns whether all of it is UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace asos
