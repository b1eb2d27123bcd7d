#include "renderer/gltf/pictures/formats.h"
#include "renderer/gltf/pictures/row_means.h"

#include <climits>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

// stb_image is private to this file, and reads these two formats only.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
// It leaves rows that a file does not have as they were allocated.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace asos {
namespace {

struct Freed {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

int size_of(PictureBytes bytes) {
  return static_cast<int>(bytes.size());  // picture_head refuses more than INT_MAX
}

/// Whether an unpacked TGA has fewer bytes than its pixels take.
bool is_cut_off(PictureBytes bytes, const PictureHead& head) {
  constexpr std::size_t head_bytes = 18, type_at = 2, bits_at = 16;
  const bool bmp = bytes.size() >= 2 && bytes[0] == 'B' && bytes[1] == 'M';
  constexpr std::uint8_t colours = 2, greys = 3;
  if (bmp || bytes.size() < head_bytes || (bytes[type_at] != colours && bytes[type_at] != greys))
    return false;
  return bytes.size() - head_bytes < head.pixels() * (bytes[bits_at] / 8u);
}

}  // namespace

bool is_bitmap(PictureBytes bytes) {
  int width = 0, height = 0, channels = 0;
  return bytes.size() <= INT_MAX &&
         stbi_info_from_memory(bytes.data(), size_of(bytes), &width, &height, &channels) == 1;
}

PictureResult<PictureHead> bitmap_head(PictureBytes bytes) {
  PictureHead head;
  int channels = 0;
  if (stbi_info_from_memory(bytes.data(), size_of(bytes), &head.width, &head.height, &channels) !=
      1)
    return tl::unexpected<std::string>("it is no usable TGA or BMP");
  if (head.width > 0 && head.height > 0) head.held_bytes = 8 * head.pixels();
  return head;
}

PictureResult<Picture> read_bitmap_picture(PictureBytes bytes, const PictureHead& head,
                                           int shrink) {
  if (is_cut_off(bytes, head)) return tl::unexpected<std::string>("it is cut off");
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, Freed> pixels(
      stbi_load_from_memory(bytes.data(), size_of(bytes), &width, &height, &channels, 4));
  if (!pixels || width != head.width || height != head.height)
    return tl::unexpected<std::string>("it cannot be decoded: its TGA or BMP data is broken");
  RowMeans rows(width, height, shrink);
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    std::copy_n(pixels.get() + row * static_cast<std::size_t>(y), row, rows.next().data());
    rows.add();
  }
  return Picture{rows.take(), {}};
}

}  // namespace asos
