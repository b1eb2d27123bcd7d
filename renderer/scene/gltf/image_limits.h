#pragma once

#include "renderer/scene/gltf/warnings.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace asos::gltf {

constexpr std::uint64_t any_number_of_pixels = ~std::uint64_t{0};

/// Why a picture that claims this size is not to be decoded from so many bytes: it would be larger
/// than textures may be, than the bytes can stand for, or than `most_pixels`.
[[nodiscard]] inline Checked<void> check_size(int width, int height, std::size_t bytes,
                                              std::uint64_t most_pixels) {
  constexpr int largest_side = 16384;
  // Deflate expands at most 1032 times, and a byte may be a whole pixel of a palette.
  constexpr std::uint64_t most_pixels_per_byte = 1100;
  constexpr std::uint64_t free_pixels = 1 << 20;
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    return fault(
        fmt::format("it is {} x {} pixels; the limit is {} a side", width, height, largest_side));
  }
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (pixels > bytes * most_pixels_per_byte + free_pixels)
    return fault(fmt::format("{} bytes cannot hold {} x {} pixels", bytes, width, height));
  if (pixels > most_pixels)
    return fault(
        fmt::format("with its {} x {} pixels the textures would be more than a file of "
                    "this size has use for",
                    width, height));
  return {};
}

}  // namespace asos::gltf
