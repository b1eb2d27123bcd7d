#pragma once

#include "renderer/scene/gltf/warnings.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace asos::gltf {

/// Why a picture that claims this size is not to be decoded from so many bytes: it would be larger
/// than textures may be, or than the bytes can stand for.
[[nodiscard]] inline Checked<void> check_size(int width, int height, std::size_t bytes) {
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
  return {};
}

}  // namespace asos::gltf
