#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <png.h>
#include <span>
#include <string>

namespace asos {

/// libpng's reader of a file in memory. It prints nothing. On errors libpng does a longjmp, which
/// `guarded` catches.
class PngInput {
 public:
  explicit PngInput(std::span<const std::uint8_t> file) : rest_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keep_message, ignore_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (info_) png_set_read_fn(png_, this, read_bytes);
  }
  ~PngInput() {
    if (png_) png_destroy_read_struct(&png_, info_ ? &info_ : nullptr, nullptr);
  }
  PngInput(const PngInput&) = delete;
  PngInput& operator=(const PngInput&) = delete;

  /// Runs a function that calls libpng. `f` must hold no objects with destructors, since errors
  /// jump out of it. Returns false if it failed, or if there is no memory for the reader.
  template <typename F>
  [[nodiscard]] bool guarded(const F& f) {
    if (!info_ || setjmp(png_jmpbuf(png_)) != 0) return false;
    f(png_, info_);
    return true;
  }

  /// Returns the reason why `guarded` failed.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  static void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    std::span<const std::uint8_t>& rest = static_cast<PngInput*>(png_get_io_ptr(png))->rest_;
    if (count > rest.size()) png_error(png, "it ends too early");
    for (std::size_t i = 0; i < count; ++i) to[i] = rest[i];
    rest = rest.subspan(count);
  }
  static void keep_message(png_structp png, png_const_charp message) {
    static_cast<PngInput*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void ignore_warning(png_structp, png_const_charp) {}

  std::span<const std::uint8_t> rest_;
  std::string message_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace asos
