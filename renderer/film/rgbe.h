#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace asos {

/// A pixel of a Radiance picture as in the file: red, green and blue with 8 bits each and a common
/// exponent (Ward, "Real Pixels", Graphics Gems II).
using Rgbe = std::array<std::uint8_t, 4>;

/// Returns the exact linear radiance of a pixel.
[[nodiscard]] inline glm::vec3 radiance_of(const Rgbe& pixel) {
  static const std::array<float, 256> units = [] {
    std::array<float, 256> all{};  // an exponent of 0 means black
    for (std::size_t e = 1; e < all.size(); ++e)
      all[e] = std::ldexp(1.0f, static_cast<int>(e) - (128 + 8));
    return all;
  }();
  return units[pixel[3]] * glm::vec3(pixel[0], pixel[1], pixel[2]);
}

}  // namespace asos
