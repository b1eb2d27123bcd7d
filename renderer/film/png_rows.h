#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/part_file.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <png.h>
#include <span>
#include <string>

namespace asos {

/// A PNG of 8-bit RGB or RGBA that is written row by row. The rules of PictureWriter apply.
class PngRows {
 public:
  /// Writes `text` as tEXt chunks, or iTXt if a value is not plain ASCII.
  [[nodiscard]] static Result<std::unique_ptr<PngRows>> create(const std::string& path, int width,
                                                               int height, const ImageText& text,
                                                               int channels = 3);
  ~PngRows();
  PngRows(const PngRows&) = delete;
  PngRows& operator=(const PngRows&) = delete;

  /// Adds whole rows of channels * width bytes each.
  [[nodiscard]] Result<void> add_rows(std::span<const std::uint8_t> pixels);
  [[nodiscard]] Result<void> finish();

 private:
  PngRows(PartFile file, std::string path, std::size_t row_bytes);
  [[nodiscard]] Error failure() const;

  PartFile file_;
  std::string path_;
  std::size_t row_bytes_;
  std::string message_;  // libpng's last error
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace asos
