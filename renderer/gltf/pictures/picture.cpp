#include "renderer/gltf/pictures/picture.h"

#include "renderer/film/image_text.h"
#include "renderer/gltf/pictures/formats.h"

#include <climits>
#include <fmt/format.h>

#include <cstddef>
#include <cstring>

namespace asos {
namespace {

tl::unexpected<std::string> fault(std::string reason) {
  return tl::unexpected<std::string>(std::move(reason));
}

/// Returns the name of a picture's format by its first bytes, for a message that it is not
/// supported.
const char* other_format_of(PictureBytes bytes) {
  const auto begins = [&](std::size_t at, const char* magic) {
    const std::size_t n = std::strlen(magic);
    return bytes.size() >= at + n && std::memcmp(bytes.data() + at, magic, n) == 0;
  };
  if (begins(0, "\xabKTX")) return "KTX";
  if (begins(0, "GIF8")) return "GIF";
  if (begins(0, "DDS ")) return "DDS";
  if (begins(4, "ftypavif")) return "AVIF";
  return nullptr;
}

/// Returns why a picture of this size is not read from this many bytes; empty: it is read.
std::string fault_of_size(const PictureHead& head, std::size_t bytes) {
  // Deflate expands at most 1032 times, and a byte may be a whole pixel of a palette.
  constexpr std::uint64_t most_pixels_per_byte = 1100;
  constexpr std::uint64_t free_pixels = 1 << 20;
  if (head.width < 1 || head.height < 1 || head.width > largest_picture_side ||
      head.height > largest_picture_side)
    return fmt::format("it is {} x {} pixels; the limit is {} a side", head.width, head.height,
                       largest_picture_side);
  if (head.pixels() > bytes * most_pixels_per_byte + free_pixels)
    return fmt::format("{} bytes cannot hold {} x {} pixels", bytes, head.width, head.height);
  return "";
}

PictureResult<PictureHead> head_of_format(PictureBytes bytes) {
  if (is_png(bytes)) return png_head(bytes);
  if (is_jpeg(bytes)) return jpeg_head(bytes);
  if (is_webp(bytes)) return webp_head(bytes);
  if (const char* format = other_format_of(bytes))
    return fault(fmt::format("{} pictures are not supported", format));
  if (is_bitmap(bytes)) return bitmap_head(bytes);
  return fault("it is no usable PNG, JPEG, WebP, TGA or BMP");
}

}  // namespace

PictureResult<PictureHead> picture_head(PictureBytes bytes) {
  if (bytes.empty()) return fault("it is empty");
  if (bytes.size() > INT_MAX) return fault("it is larger than 2 GiB");
  PictureResult<PictureHead> head = head_of_format(bytes);
  if (!head) return head;
  if (std::string wrong = fault_of_size(*head, bytes.size()); !wrong.empty())
    return fault(std::move(wrong));
  return head;
}

PictureResult<Picture> read_picture(PictureBytes bytes, int shrink) {
  constexpr std::uint64_t free_held_bytes = std::uint64_t{128} << 20, held_bytes_per_byte = 16;
  const PictureResult<PictureHead> head = picture_head(bytes);
  if (!head) return fault(head.error());
  if (head->held_bytes > free_held_bytes + held_bytes_per_byte * bytes.size())
    return fault(
        fmt::format("its {} x {} pixels come interlaced, progressive, lossless or as a bitmap, "
                    "which takes more memory "
                    "than a picture of {} bytes has use for",
                    head->width, head->height, bytes.size()));
  if (is_png(bytes)) return read_png_picture(bytes, *head, shrink);
  if (is_jpeg(bytes)) return read_jpeg_picture(bytes, *head, shrink);
  if (is_webp(bytes)) return read_webp_picture(bytes, *head, shrink);
  return read_bitmap_picture(bytes, *head, shrink);
}

}  // namespace asos
