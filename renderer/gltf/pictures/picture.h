#pragma once

#include "renderer/scene/scene.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>

// Reads texture pictures: PNG, JPEG and WebP, and the TGA and BMP of models in older formats. The
// first three are read row by row and reduced on the way if necessary, so that a few bytes that
// expand to many pixels do not take much memory.

namespace asos {

using PictureBytes = std::span<const std::uint8_t>;

/// The data in a picture's head.
struct PictureHead {
  int width = 0;  ///< 1 to largest_picture_side
  int height = 0;
  /// Memory of the decoder besides the rows that it returns. It is small except for interlaced PNG,
  /// progressive JPEG, lossless WebP, TGA and BMP, whose rows are complete only at the end.
  std::uint64_t held_bytes = 0;

  [[nodiscard]] std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
};

inline constexpr int largest_picture_side = 16384;

/// A picture of 8-bit RGBA; 16-bit PNGs keep 16 bits unless they are reduced.
struct Picture {
  Image image;
  std::string remark;  ///< a fault of a picture that is shown nevertheless; empty: none
};

template <typename T>
using PictureResult = tl::expected<T, std::string>;

/// Reads a picture's head. Faults: another format, a broken head, dimensions that are impossible
/// for the number of bytes.
[[nodiscard]] PictureResult<PictureHead> picture_head(PictureBytes bytes);

/// Reads a picture, each texel as the mean of `shrink` by `shrink` of its pixels, or of those that
/// exist at the right and lower border. `shrink` is a power of two, 1 to 4096. Faults: those of
/// picture_head, broken data, and a decoder that would need too much memory for files of this size.
[[nodiscard]] PictureResult<Picture> read_picture(PictureBytes bytes, int shrink = 1);

/// Returns the side of a picture that was read with `shrink`.
[[nodiscard]] constexpr int shrunk(int side, int shrink) {
  return (side + shrink - 1) / shrink;
}

}  // namespace asos
