#pragma once

#include <string>
#include <string_view>

namespace asos::ui {

/// Breaks text into lines no wider than `room`, between words only; a wider word stays whole. (Dear
/// ImGui also breaks after a full stop, and so within numbers.) `width` measures a text.
template <typename Width>
[[nodiscard]] std::string in_whole_words(std::string_view text, float room, Width&& width) {
  std::string lines;
  std::size_t begun = 0;  // start of the last line
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
