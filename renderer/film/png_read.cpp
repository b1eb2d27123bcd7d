#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"
#include "renderer/film/image_text.h"
#include "renderer/film/png_input.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <png.h>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace png {
namespace {

constexpr std::int64_t longest_side = 1 << 20;
// Deflate expands at most 1032 times, and a byte may be eight pixels.
constexpr std::int64_t most_pixels_per_byte = 8 * 1032;

/// Reads the pixels. Returns an empty string, or the reason of a failure.
std::string read_pixels(std::span<const std::uint8_t> file, RgbImage& image) {
  PngInput input(file);
  const auto reason = [&] { return fmt::format("cannot be decoded ({})", input.message()); };
  std::int64_t width = 0, height = 0;
  std::size_t row = 0;
  const bool begun = input.guarded([&](png_structp png, png_infop info) {
    png_set_user_limits(png, longest_side, longest_side);
    // Skips all other chunks; png_text reads the text, with a size limit.
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png, info);
    png_set_expand(png);
    png_set_strip_16(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    width = png_get_image_width(png, info);
    height = png_get_image_height(png, info);
    row = png_get_rowbytes(png, info);
  });
  if (!begun) return reason();
  if (width * height > most_pixels_per_byte * static_cast<std::int64_t>(file.size()))
    return fmt::format("{} bytes cannot hold {} x {} pixels", file.size(), width, height);
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  if (row != 3 * static_cast<std::size_t>(width)) return "its pixels are of no known kind";
  image.rgb.resize(row * static_cast<std::size_t>(height));
  std::vector<png_bytep> rows;
  for (std::size_t at = 0; at < image.rgb.size(); at += row) rows.push_back(&image.rgb[at]);
  const bool read =
      input.guarded([&](png_structp png, png_infop) { png_read_image(png, rows.data()); });
  return read ? "" : reason();
}

}  // namespace
}  // namespace png

Result<RgbImage> read_png(const std::string& path) {
  const auto file = read_file(path, png_rules());
  if (!file) return unexpected(Error{path, file.error()});
  RgbImage image;
  if (std::string reason = png::read_pixels(*file, image); !reason.empty())
    return unexpected(Error{path, std::move(reason)});
  return png_text(path, *file).map([&](ImageText text) {
    image.text = std::move(text);
    return std::move(image);
  });
}

}  // namespace asos
