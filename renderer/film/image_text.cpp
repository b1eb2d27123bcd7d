#include "renderer/film/image_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <zlib.h>

namespace asos {
namespace {

constexpr std::uint64_t largest_picture = std::uint64_t{4} << 30;

std::uint32_t big_endian(const std::uint8_t* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
         std::uint32_t{p[3]};
}

/// Returns the decompressed text of at most `most` bytes; none if it is longer or damaged.
std::optional<std::string> inflated(std::string_view packed, std::size_t most) {
  std::string text(std::min(std::max(8 * packed.size(), std::size_t{1} << 12), most), '\0');
  for (;;) {
    uLongf size = text.size();
    const int outcome = uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                                   reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (outcome == Z_OK) {
      text.resize(size);
      return text;
    }
    if (outcome != Z_BUF_ERROR || text.size() >= most) return std::nullopt;
    text.resize(std::min(4 * text.size(), most));
  }
}

// Removes the part up to the next zero byte from `rest` and returns it.
std::optional<std::string_view> take_word(std::string_view& rest) {
  const std::size_t end = rest.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return word;
}

/// Returns key and value of a chunk's body (PNG specification, section 11.3.4), of at most `most`
/// bytes.
std::optional<std::pair<std::string, std::string>> read_chunk(std::string_view type,
                                                              std::string_view body,
                                                              std::size_t most) {
  const auto key = take_word(body);
  if (!key) return std::nullopt;
  bool packed = type == "zTXt";
  if (packed || type == "iTXt") {
    const std::size_t flags = packed ? 1 : 2;  // compression flag (iTXt) and method
    if (body.size() < flags) return std::nullopt;
    if (!packed) packed = body[0] != 0;
    body.remove_prefix(flags);
  }
  // iTXt: a language and a translated key.
  if (type == "iTXt" && (!take_word(body) || !take_word(body))) return std::nullopt;
  if (!packed) return std::pair(std::string(*key), std::string(body));
  auto text = inflated(body, most);
  if (!text) return std::nullopt;
  return std::pair(std::string(*key), *std::move(text));
}

Error too_much_text(const std::string& path) {
  return {path,
          fmt::format("the text in it is damaged, or more than {} MB", most_image_text >> 20)};
}

}  // namespace

bool is_png(std::span<const std::uint8_t> file) {
  return begins_with(file, "\x89PNG\r\n\x1a\n");
}

bool is_exr(std::span<const std::uint8_t> file) {
  return begins_with(file, "\x76\x2f\x31\x01");
}

FileRules png_rules() {
  return {largest_picture,
          [](const FileHead& head) { return is_png(head.bytes) ? "" : "is not a PNG"; }};
}

Result<ImageText> png_text(const std::string& path, std::span<const std::uint8_t> file) {
  ImageText text;
  std::size_t at = 8, left = most_image_text;
  while (at + 12 <= file.size()) {
    const std::size_t size = big_endian(file.data() + at);
    if (size > file.size() - at - 12) break;
    const std::uint8_t* start = file.data() + at + 4;
    const std::string_view type(reinterpret_cast<const char*>(start), 4);
    if (type == "tEXt" || type == "zTXt" || type == "iTXt") {
      const bool whole =
          crc32(0, start, static_cast<uInt>(size + 4)) == big_endian(start + 4 + size);
      auto entry = read_chunk(type, {reinterpret_cast<const char*>(start) + 4, size}, left);
      // An empty entry takes memory, too.
      constexpr std::size_t room = sizeof(ImageText::value_type);
      const std::size_t taken = entry ? entry->first.size() + entry->second.size() + room : 0;
      if (!whole || !entry || taken > left) return unexpected(too_much_text(path));
      left -= taken;
      text.push_back(*std::move(entry));
    }
    at += size + 12;
  }
  return text;
}

Result<ImageText> read_image_text(const std::string& path) {
  const FileRules rules{
      largest_picture, [](const FileHead& head) {
        return is_png(head.bytes) || is_exr(head.bytes) ? "" : "is neither a PNG nor an EXR";
      }};
  const auto file = read_file(path, rules);
  if (!file) return unexpected(Error{path, file.error()});
  return is_png(*file) ? png_text(path, *file) : exr_text(path, *file);
}

}  // namespace asos
