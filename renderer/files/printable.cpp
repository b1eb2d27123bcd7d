#include "renderer/files/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace asos {
namespace {

struct Range {
  std::uint32_t first, last;
};

// Characters that control a terminal, break a line, or make text look like another text: controls,
// soft hyphen, direction marks (Unicode's Bidi_Control), separators, other invisible marks and
// tags.
constexpr std::array<Range, 12> not_shown{{{0x00, 0x1f},
                                           {0x7f, 0x9f},
                                           {0xad, 0xad},
                                           {0x61c, 0x61c},
                                           {0x180e, 0x180e},
                                           {0x200b, 0x200b},
                                           {0x200e, 0x200f},
                                           {0x2028, 0x202e},
                                           {0x2060, 0x206f},
                                           {0xfeff, 0xfeff},
                                           {0xfff9, 0xfffb},
                                           {0xe0000, 0xe007f}}};

bool is_shown(std::uint32_t character) {
  return std::none_of(not_shown.begin(), not_shown.end(), [character](const Range& range) {
    return character >= range.first && character <= range.last;
  });
}

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<std::uint8_t>(text[i]);
}

/// Returns the first character of `text`, which has `length` bytes.
std::uint32_t character_of(std::string_view text, std::size_t length) {
  if (length == 1) return byte_at(text, 0);
  std::uint32_t character = byte_at(text, 0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) character = character << 6 | (byte_at(text, i) & 0x3f);
  return character;
}

std::string escape(std::uint32_t character) {
  if (character == '\n') return "\\n";
  if (character == '\r') return "\\r";
  if (character == '\t') return "\\t";
  return character < 0x80 ? fmt::format("\\x{:02x}", character)
                          : fmt::format("\\u{{{:x}}}", character);
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const std::uint32_t lead = byte_at(text, 0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte_at(text, i) & 0xc0) != 0x80) return 0;
  // Reject overlong encodings, halves of UTF-16 pairs, and values beyond the last character.
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const std::uint32_t character = character_of(text, length);
  const bool is_half = character >= 0xd800 && character <= 0xdfff;
  return character >= least[length] && character <= 0x10ffff && !is_half ? length : 0;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      shown += fmt::format("\\x{:02x}", byte_at(text, 0));
      text.remove_prefix(1);
      continue;
    }
    const std::uint32_t character = character_of(text, length);
    shown += is_shown(character) ? std::string(text.substr(0, length)) : escape(character);
    text.remove_prefix(length);
  }
  return shown;
}

}  // namespace asos
