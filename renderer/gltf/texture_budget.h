#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace asos::gltf {

/// A picture of a file as its head describes it.
struct PictureClaim {
  int width = 0;  ///< pixels; 0: it is no picture
  int height = 0;
  std::uint64_t bytes = 0;  ///< as it is stored
};

/// How many pixels the pictures of a file may have together that take so many bytes in it: what
/// textures of that size show, and few enough that those of a small file take little memory.
[[nodiscard]] std::uint64_t most_texels(std::uint64_t picture_bytes);

/// By how much to reduce each as it is read (read_picture), a power of two; 1: not at all. All
/// together have most_texels at most, and those that are larger than others are reduced first.
[[nodiscard]] std::vector<int> shrinks_of(std::span<const PictureClaim> claims);

}  // namespace asos::gltf
