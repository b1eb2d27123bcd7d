#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/part_file.h"

#include <cstdint>
#include <memory>
#include <png.h>
#include <span>
#include <string>

namespace asos {

/// A PNG of 8-bit RGB that is written row by row; what PictureWriter says holds here too.
class PngRows {
 public:
  /// `text` as tEXt chunks, iTXt where a value is not plain ASCII.
  [[nodiscard]] static Result<std::unique_ptr<PngRows>> create(const std::string& path, int width,
                                                               int height, const ImageText& text);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  /// Whole rows, 3 * width bytes each.
  [[nodiscard]] Result<void> add_rows(std::span<const std::uint8_t> rgb);
  [[nodiscard]] Result<void> finish();

 private:
  PngRows(PartFile file, std::string path, int width);
  [[nodiscard]] Error failure() const;

  PartFile file_;
  std::string path_;
  int width_;
  std::string message_;  // libpng's last error
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace asos
