#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <stb_image.h>
#include <stb_image_write.h>
#include <string_view>

namespace asos {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c & 1u) ? 0xedb88320u ^ (c >> 1) : c >> 1;
    table[i] = c;
  }
  return table;
}

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  static const std::array<std::uint32_t, 256> table = make_crc_table();
  std::uint32_t c = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) c = table[(c ^ data[i]) & 0xffu] ^ (c >> 8);
  return c ^ 0xffffffffu;
}

void append_big_endian(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

std::uint32_t big_endian(const std::uint8_t* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
         std::uint32_t{p[3]};
}

void append(Bytes& out, std::string_view text) {
  out.insert(out.end(), text.begin(), text.end());
}

bool plain_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c == '\n' || (c >= 32 && c < 127); });
}

bool valid_key(const std::string& key) {
  return !key.empty() && key.size() <= 79 && plain_ascii(key) &&
         key.find('\n') == std::string::npos && key.front() != ' ' && key.back() != ' ';
}

/// tEXt is Latin-1; iTXt is UTF-8, here without compression, language or translated key.
void append_text_chunk(Bytes& out, const std::string& key, const std::string& value) {
  const bool plain = plain_ascii(value);
  Bytes body;
  append(body, plain ? "tEXt" : "iTXt");
  append(body, key);
  body.insert(body.end(), plain ? 1u : 5u, std::uint8_t{0});
  append(body, value);
  append_big_endian(out, static_cast<std::uint32_t>(body.size() - 4));
  out.insert(out.end(), body.begin(), body.end());
  append_big_endian(out, crc32(body.data(), body.size()));
}

// The signature and the header chunk have the same length in every PNG; text may follow at once.
constexpr std::size_t after_header = 8 + 4 + 4 + 13 + 4;

ImageText read_text(const Bytes& file) {
  ImageText text;
  std::size_t at = 8;
  while (at + 12 <= file.size()) {
    const std::size_t size = big_endian(file.data() + at);
    if (size > file.size() - at - 12) break;
    const char* start = reinterpret_cast<const char*>(file.data() + at);
    const std::string_view type(start + 4, 4);
    const std::string_view body(start + 8, size);
    const std::size_t key_end = body.find('\0');
    const std::size_t skip = type == "iTXt" ? 5 : 1;
    if ((type == "tEXt" || type == "iTXt") && key_end != std::string_view::npos &&
        key_end + skip <= body.size()) {
      text.emplace_back(body.substr(0, key_end), body.substr(key_end + skip));
    }
    at += size + 12;
  }
  return text;
}

}  // namespace

Result<void> write_png(const std::string& path, const RgbImage& image) {
  // stb keeps sizes in ints, and filters every row at three bytes a pixel and one more.
  const auto width = static_cast<std::uint64_t>(std::max(image.width, 0));
  const auto height = static_cast<std::uint64_t>(std::max(image.height, 0));
  if (width == 0 || height == 0) return unexpected(Error{path, "the picture is empty"});
  if ((3 * width + 1) * height > std::numeric_limits<int>::max() / 2) {
    return unexpected(Error{path, fmt::format("a picture of {} x {} pixels is too big for PNG "
                                              "here; EXR holds it",
                                              width, height)});
  }
  if (image.rgb.size() != 3 * width * height) {
    return unexpected(Error{path, "the picture's data do not fit its size"});
  }
  for (const auto& [key, value] : image.text) {
    if (!valid_key(key)) return unexpected(Error{path, "text key \"" + key + "\" is not valid"});
    if (value.find('\0') != std::string::npos) {
      return unexpected(Error{path, "the text of \"" + key + "\" holds a zero byte"});
    }
  }

  Bytes png;
  const auto collect = [](void* out, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(out)->insert(static_cast<Bytes*>(out)->end(), bytes, bytes + size);
  };
  if (!stbi_write_png_to_func(collect, &png, image.width, image.height, 3, image.rgb.data(),
                              3 * image.width) ||
      png.size() < after_header) {
    return unexpected(Error{path, "the picture could not be encoded"});
  }
  Bytes chunks;
  for (const auto& [key, value] : image.text) append_text_chunk(chunks, key, value);
  png.insert(png.begin() + static_cast<std::ptrdiff_t>(after_header), chunks.begin(), chunks.end());
  return write_file_atomically(path, png);
}

Result<void> write_png(const std::string& path, const Film& film, float exposure_ev,
                       const ImageText& text) {
  RgbImage image{film.width, film.height, {}, text};
  image.rgb.reserve(3 * film.radiance.size());
  for (const glm::vec3& radiance : film.radiance) {
    const glm::u8vec3 c = display_bytes(radiance, exposure_ev);
    image.rgb.insert(image.rgb.end(), {c.x, c.y, c.z});
  }
  return write_png(path, image);
}

Result<void> write_split_map_png(const std::string& path, const Film& film, SplitMapKey key,
                                 const ImageText& text) {
  RgbImage image{film.width, film.height, {}, text};
  const std::size_t pixels = film.split_level.size();
  image.rgb.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const glm::u8vec3 c = key.colour(key.value(film, i));
    image.rgb.insert(image.rgb.end(), {c.x, c.y, c.z});
  }
  return write_png(path, image);
}

Result<RgbImage> read_png(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unexpected(Error{path, "cannot be opened"});
  const Bytes file((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  if (file.size() < after_header || !std::equal(signature.begin(), signature.end(), file.begin()) ||
      file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return unexpected(Error{path, "is not a PNG"});
  }
  RgbImage image;
  int channels = 0;
  stbi_uc* pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &image.width,
                                          &image.height, &channels, 3);
  if (!pixels) return unexpected(Error{path, "cannot be decoded"});
  image.rgb.assign(pixels, pixels + 3 * static_cast<std::size_t>(image.width) *
                                        static_cast<std::size_t>(image.height));
  stbi_image_free(pixels);
  image.text = read_text(file);
  return image;
}

}  // namespace asos
