#pragma once

#include <string>
#include <string_view>

namespace asos::ui {

/// The text in lines no wider than `room` that are broken between words only: Dear ImGui breaks
/// behind a full stop, too, and with it numbers. A word that is wider stays whole. `width` measures
/// a text.
template <typename Width>
[[nodiscard]] std::string in_whole_words(std::string_view text, float room, Width&& width) {
  std::string lines;
  std::size_t begun = 0;  // where the last line begins
  while (true) {
    const std::size_t end = text.find(' ', 1);
    const std::string_view word = text.substr(0, end);  // with the space before it
    const std::string longer = lines.substr(begun) + std::string(word);
    if (begun < lines.size() && width(longer) > room) {
      lines += '\n';
      begun = lines.size();
      lines += word.substr(word.find_first_not_of(' ') == std::string_view::npos
                               ? word.size()
                               : word.find_first_not_of(' '));
    } else {
      lines += word;
    }
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end);
  }
}

}  // namespace asos::ui
