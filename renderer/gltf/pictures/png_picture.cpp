#include "renderer/film/png_input.h"
#include "renderer/gltf/pictures/formats.h"
#include "renderer/gltf/pictures/row_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace asos {
namespace {

tl::unexpected<std::string> broken(const PngInput& input) {
  return tl::unexpected(fmt::format("it is no usable PNG ({})", input.message()));
}

void read_info(png_structp png, png_infop info) {
  // Sizes are checked elsewhere, from the head.
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // Text, profiles and the like cost memory and time, and are not used.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  // Pictures with wrong checksums are displayed nevertheless, as in other programs.
  png_set_crc_action(png, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);
  png_set_option(png, PNG_IGNORE_ADLER32, PNG_OPTION_ON);
  png_read_info(png, info);
}

/// Converts any format to RGBA, with 16 bits if `wide`, else with 8.
void ask_for_rgba(png_structp png, png_infop info, bool wide) {
  png_set_expand(png);
  if (!wide) png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

/// Makes an image with 16-bit texels from rows with the upper byte first; with 8-bit texels if that
/// loses nothing.
Image split_bytes(Image wide) {
  Image image;
  image.width = wide.width / 2;
  image.height = wide.height;
  const SharedBytes::Bytes& both = wide.rgba.get();
  SharedBytes::Bytes high(both.size() / 2), low(both.size() / 2);
  unsigned differences = 0;
  for (std::size_t i = 0; i < high.size(); ++i) {
    high[i] = both[2 * i];
    low[i] = both[2 * i + 1];
    differences |= high[i] ^ low[i];  // none: 257 times an 8-bit value
  }
  image.rgba = SharedBytes(std::move(high));
  if (differences != 0) image.low = SharedBytes(std::move(low));
  return image;
}

}  // namespace

// Reads only IHDR, so that oversized images are rejected before decoding.
PictureResult<PictureHead> png_head(PictureBytes bytes) {
  constexpr std::size_t width_at = 16, height_at = 20, depth_at = 24, interlaced_at = 28, end = 33;
  if (bytes.size() < end || std::memcmp(bytes.data() + 12, "IHDR", 4) != 0)
    return tl::unexpected<std::string>("it is no usable PNG (its head is cut off)");
  const auto side = [&](std::size_t at) {
    std::uint32_t pixels = 0;
    for (std::size_t i = at; i < at + 4; ++i) pixels = pixels << 8 | bytes[i];
    return static_cast<int>(std::min<std::uint32_t>(pixels, PNG_UINT_31_MAX));
  };
  PictureHead head{side(width_at), side(height_at), 0};
  if (bytes[interlaced_at] != PNG_INTERLACE_NONE)
    head.held_bytes = (bytes[depth_at] == 16 ? 8 : 4) * head.pixels();
  return head;
}

PictureResult<Picture> read_png_picture(PictureBytes bytes, const PictureHead& head, int shrink) {
  PngInput input(bytes);
  std::size_t row = 4 * static_cast<std::size_t>(head.width);
  std::size_t made = 0;
  bool wide = false;
  png_uint_32 width = 0;
  const bool begun = input.guarded([&](png_structp png, png_infop info) {
    read_info(png, info);
    // Reduced pictures lose more than their lower bytes.
    wide = png_get_bit_depth(png, info) == 16 && shrink == 1;
    ask_for_rgba(png, info, wide);
    made = png_get_rowbytes(png, info);
    width = png_get_image_width(png, info);
  });
  if (!begun) return broken(input);
  if (wide) row *= 2;
  if (width != static_cast<png_uint_32>(head.width) || made != row)
    return tl::unexpected<std::string>("its pixels are of no known kind");
  // All rows of an interlaced picture stay in memory until the last one is read.
  const bool interlaced = head.held_bytes > 0;
  std::vector<std::uint8_t> pixels(interlaced ? row * static_cast<std::size_t>(head.height) : 0);
  if (interlaced) {
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < pixels.size(); at += row) rows.push_back(&pixels[at]);
    const bool read =
        input.guarded([&](png_structp png, png_infop) { png_read_image(png, rows.data()); });
    if (!read) return broken(input);
  }
  RowMeans means(wide ? 2 * head.width : head.width, head.height, shrink);
  for (std::size_t y = 0; y < static_cast<std::size_t>(head.height); ++y) {
    const std::span<std::uint8_t> at = means.next();
    if (interlaced) std::copy_n(&pixels[y * row], row, at.begin());
    const bool read = interlaced || input.guarded([&](png_structp png, png_infop) {
      png_read_row(png, at.data(), nullptr);
    });
    if (!read) return broken(input);
    means.add();
  }
  return Picture{wide ? split_bytes(means.take()) : means.take(), {}};
}

}  // namespace asos
