#pragma once

#include <cstdint>

namespace asos {

/// Random numbers as a function of their purpose: there is no state, so they depend neither on
/// threads nor on the order of work. The mixer is that of SplitMix64 (Steele, Lea and Flood 2014,
/// "Fast splittable pseudorandom number generators"), applied once for each key.
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Returns the bits of sample `index` of pixel (x, y).
[[nodiscard]] constexpr std::uint64_t pixel_random(int x, int y, std::uint32_t index) {
  const std::uint64_t pixel = (std::uint64_t{static_cast<std::uint32_t>(x)} << 32) |
                              std::uint64_t{static_cast<std::uint32_t>(y)};
  return mix_bits(mix_bits(pixel) ^ index);
}

/// Two independent numbers in [0, 1) from 64 random bits.
struct RandomPair {
  double u;
  double v;
};
[[nodiscard]] constexpr RandomPair unit_pair(std::uint64_t bits) {
  constexpr double scale = 1.0 / 4294967296.0;
  return {static_cast<double>(bits >> 32) * scale,
          static_cast<double>(bits & 0xffffffffULL) * scale};
}

}  // namespace asos
