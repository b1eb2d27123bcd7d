#include "renderer/film/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace asos {
namespace {

/// Removes text up to its final zero from `rest`; false if there is none.
bool take_text(std::span<const std::uint8_t>& rest, std::size_t& length) {
  const auto end = std::find(rest.begin(), rest.end(), std::uint8_t{0});
  if (end == rest.end()) return false;
  length = static_cast<std::size_t>(end - rest.begin());
  rest = rest.subspan(length + 1);
  return true;
}

}  // namespace

std::string exr_header_error(std::span<const std::uint8_t> file) {
  constexpr std::size_t magic_and_version = 8, size_bytes = 4;
  constexpr std::uint8_t multipart = 0x10;
  if (file.size() < magic_and_version) return "it ends too early";
  const bool has_parts = (file[5] & multipart) != 0;
  auto rest = file.subspan(magic_and_version);
  // An empty name ends a part's attributes. In multi-part files an empty part ends the list of
  // parts.
  for (bool empty_part = true;;) {
    std::size_t name = 0, type = 0;
    if (!take_text(rest, name)) return "it ends too early";
    if (name == 0) {
      if (!has_parts || empty_part) return "";
      empty_part = true;
      continue;
    }
    empty_part = false;
    if (!take_text(rest, type) || rest.size() < size_bytes) return "it ends too early";
    const std::uint32_t size = rest[0] | std::uint32_t{rest[1]} << 8 |
                               std::uint32_t{rest[2]} << 16 | std::uint32_t{rest[3]} << 24;
    rest = rest.subspan(size_bytes);
    if (size > rest.size())
      return fmt::format("an attribute of its header claims {} bytes and {} are left", size,
                         rest.size());
    rest = rest.subspan(size);
  }
}

}  // namespace asos
