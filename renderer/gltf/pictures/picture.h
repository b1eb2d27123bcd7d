#pragma once

#include "renderer/scene/scene.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>

// Pictures as textures come: PNG, JPEG and WebP. They are read row by row and made smaller
// meanwhile where they have to be, so that a few bytes that stand for many pixels cost no memory.

namespace asos {

using PictureBytes = std::span<const std::uint8_t>;

/// What a picture's head says of it.
struct PictureHead {
  int width = 0;  ///< 1 to largest_picture_side
  int height = 0;
  /// Bytes of the picture that its decoder holds beside the rows that it hands out: little but for
  /// interlaced PNG, progressive JPEG and lossless WebP, whose rows are known last of all.
  std::uint64_t held_bytes = 0;

  [[nodiscard]] std::uint64_t pixels() const {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }
};

inline constexpr int largest_picture_side = 16384;

/// A picture of 8-bit RGBA; 16-bit PNGs lose their lower half.
struct Picture {
  Image image;
  std::string remark;  ///< what is wrong with it though it is shown; empty: nothing
};

template <typename T>
using PictureResult = tl::expected<T, std::string>;

/// Faults: another format, a broken head, dimensions that the bytes cannot stand for.
[[nodiscard]] PictureResult<PictureHead> picture_head(PictureBytes bytes);

/// The picture, each texel the mean of `shrink` by `shrink` of its pixels; at its right and lower
/// border of what there is. `shrink`: a power of two, 1 to 4096. Faults: those of picture_head,
/// broken data, and a decoder that would hold more than files of this size have use for.
[[nodiscard]] PictureResult<Picture> read_picture(PictureBytes bytes, int shrink = 1);

/// The side of a picture that was read with `shrink`.
[[nodiscard]] constexpr int shrunk(int side, int shrink) {
  return (side + shrink - 1) / shrink;
}

}  // namespace asos
