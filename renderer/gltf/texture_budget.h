#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace asos::gltf {

/// A picture of a file, as its head describes it.
struct DecodedImageSize {
  int width = 0;  ///< pixels; 0: it is no picture
  int height = 0;
  std::uint64_t bytes = 0;  ///< as it is stored
};

/// Returns the limit on a file's decoded pixels, given the bytes of all its stored pictures. It is
/// enough for real textures, but small files cannot claim huge pictures.
[[nodiscard]] std::uint64_t most_texels(std::uint64_t picture_bytes);

/// Returns the reduction of each picture while it is read (read_picture), a power of two; 1: none.
/// The total is at most most_texels, and the largest pictures are reduced first.
[[nodiscard]] std::vector<int> shrinks_of(std::span<const DecodedImageSize> claims);

}  // namespace asos::gltf
