#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Makes an image from the rows of a larger one, from top to bottom. Each texel is the mean of
/// shrink by shrink pixels, channel by channel as stored, or of those that exist at the right and
/// lower border.
class RowMeans {
 public:
  /// `shrink`: 1 to 4096, so that sums stay below 2^32.
  RowMeans(int width, int height, int shrink);

  /// Returns 4 * width bytes, into which the next row is to be written before `add`.
  [[nodiscard]] std::span<std::uint8_t> next();
  /// Adds the row that was written.
  void add();
  /// Returns the image; missing rows are black without alpha.
  [[nodiscard]] Image take();

 private:
  void put_row();

  int width_, shrink_, row_ = 0;
  int rows_summed_ = 0;
  Image image_;
  std::vector<std::uint8_t> pixels_;  // of the next row; empty if they are the image's texels
  std::vector<std::uint32_t> sums_;   // of the texels of one row
};

}  // namespace asos
