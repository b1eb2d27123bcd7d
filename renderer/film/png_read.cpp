#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"
#include "renderer/film/image_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <csetjmp>
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

/// What libpng takes from the file, and what it says where it fails.
struct Source {
  std::span<const std::uint8_t> rest;
  std::string message;
};

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  std::span<const std::uint8_t>& rest = static_cast<Source*>(png_get_io_ptr(png))->rest;
  if (count > rest.size()) png_error(png, "it ends too early");
  std::copy_n(rest.begin(), count, to);
  rest = rest.subspan(count);
}

void keep_message(png_structp png, png_const_charp message) {
  static_cast<Source*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// libpng's reader of one file.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> file) : source_{file, {}}, bytes_(file.size()) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_message, ignore_warning);
    if (png_) info_ = png_create_info_struct(png_);
  }
  ~Reader() {
    if (png_) png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Empty where it went well, else why not.
  [[nodiscard]] std::string read(RgbImage& image) {
    if (!info_ || !guarded([this] { read_info(); })) return reason();
    const std::int64_t width = png_get_image_width(png_, info_);
    const std::int64_t height = png_get_image_height(png_, info_);
    if (width * height > most_pixels_per_byte * static_cast<std::int64_t>(bytes_))
      return fmt::format("{} bytes cannot hold {} x {} pixels", bytes_, width, height);
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    const std::size_t row = 3 * static_cast<std::size_t>(width);
    if (png_get_rowbytes(png_, info_) != row) return "its pixels are of no known kind";
    image.rgb.resize(row * static_cast<std::size_t>(height));
    std::vector<png_bytep> rows;
    for (std::size_t at = 0; at < image.rgb.size(); at += row) rows.push_back(&image.rgb[at]);
    return guarded([&] { png_read_image(png_, rows.data()); }) ? "" : reason();
  }

 private:
  // libpng comes back by a jump where it fails: `f` must hold nothing that has to be destroyed.
  template <typename F>
  bool guarded(const F& f) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    f();
    return true;
  }
  [[nodiscard]] std::string reason() const {
    return fmt::format("cannot be decoded ({})", source_.message);
  }

  void read_info() {
    png_set_read_fn(png_, &source_, read_bytes);
    png_set_user_limits(png_, longest_side, longest_side);
    // Text is read by png_text, which counts it; nothing else beside the pixels matters.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_strip_16(png_);
    png_set_strip_alpha(png_);
    png_set_gray_to_rgb(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  Source source_;
  std::size_t bytes_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace
}  // namespace png

Result<RgbImage> read_png(const std::string& path) {
  const auto file = read_file(path, png_rules());
  if (!file) return unexpected(Error{path, file.error()});
  RgbImage image;
  if (std::string reason = png::Reader(*file).read(image); !reason.empty())
    return unexpected(Error{path, std::move(reason)});
  return png_text(path, *file).map([&](ImageText text) {
    image.text = std::move(text);
    return std::move(image);
  });
}

}  // namespace asos
