#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asos {

/// Text that comes from outside (names, paths, whatever a file says) as it may be shown: one line
/// of valid UTF-8 that a terminal only prints. Control characters, line separators, marks that turn
/// the direction of text and bytes that are no UTF-8 become escapes such as \n, \x1b and \u{202e};
/// all else stays, and so does what has been escaped before.
[[nodiscard]] std::string printable(std::string_view text);

/// The length in bytes of the UTF-8 character that `text` begins with, 0 where it begins with none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Whether all of it is UTF-8.
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace asos
