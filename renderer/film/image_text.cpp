#include "renderer/film/image_text.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <zlib.h>

namespace asos {
namespace {

constexpr std::size_t most_text = std::size_t{16} << 20;

std::uint32_t big_endian(const std::uint8_t* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
         std::uint32_t{p[3]};
}

std::optional<std::string> inflated(std::string_view packed) {
  std::string text(std::clamp(8 * packed.size(), std::size_t{1} << 12, most_text), '\0');
  for (;;) {
    uLongf size = text.size();
    const int outcome = uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                                   reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (outcome == Z_OK) {
      text.resize(size);
      return text;
    }
    if (outcome != Z_BUF_ERROR || text.size() >= most_text) return std::nullopt;
    text.resize(std::min(4 * text.size(), most_text));
  }
}

// The part of `rest` up to its next zero byte, which is taken off.
std::optional<std::string_view> take_word(std::string_view& rest) {
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return word;
}

/// Key and value of the body of a chunk (PNG specification, section 11.3.4).
std::optional<std::pair<std::string, std::string>> read_chunk(std::string_view type,
                                                              std::string_view body) {
  const auto key = take_word(body);
  if (!key) return std::nullopt;
  bool packed = type == "zTXt";
  if (packed || type == "iTXt") {
    const std::size_t flags = packed ? 1 : 2;  // compression flag (iTXt) and method
    if (body.size() < flags) return std::nullopt;
    if (!packed) packed = body[0] != 0;
    body.remove_prefix(flags);
  }
  // iTXt: a language and a key translated into it.
  if (type == "iTXt" && (!take_word(body) || !take_word(body))) return std::nullopt;
  if (!packed) return std::pair(std::string(*key), std::string(body));
  auto text = inflated(body);
  if (!text) return std::nullopt;
  return std::pair(std::string(*key), *std::move(text));
}

}  // namespace

bool is_png(const std::vector<std::uint8_t>& file) {
  constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return file.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), file.begin());
}

Result<ImageText> png_text(const std::string& path, const std::vector<std::uint8_t>& file) {
  ImageText text;
  std::size_t at = 8;
  while (at + 12 <= file.size()) {
    const std::size_t size = big_endian(file.data() + at);
    if (size > file.size() - at - 12) break;
    const std::uint8_t* start = file.data() + at + 4;
    const std::string_view type(reinterpret_cast<const char*>(start), 4);
    if (type == "tEXt" || type == "zTXt" || type == "iTXt") {
      const bool whole =
          crc32(0, start, static_cast<uInt>(size + 4)) == big_endian(start + 4 + size);
      auto entry = read_chunk(type, {reinterpret_cast<const char*>(start) + 4, size});
      if (!whole || !entry) return unexpected(Error{path, "the text in it is damaged"});
      text.push_back(*std::move(entry));
    }
    at += size + 12;
  }
  return text;
}

Result<ImageText> read_image_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unexpected(Error{path, "cannot be opened"});
  const std::vector<std::uint8_t> file((std::istreambuf_iterator<char>(stream)),
                                       std::istreambuf_iterator<char>());
  if (is_png(file)) return png_text(path, file);
  constexpr std::array<std::uint8_t, 4> exr{0x76, 0x2f, 0x31, 0x01};
  if (file.size() < exr.size() || !std::equal(exr.begin(), exr.end(), file.begin()))
    return unexpected(Error{path, "is neither a PNG nor an EXR"});
  return exr_text(path, file);
}

}  // namespace asos
