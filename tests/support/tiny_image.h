#pragma once

#include "renderer/scene/scene.h"

#include <array>
#include <cstdint>
#include <functional>

// Images computed texel by texel.

namespace asos::test {

using Texel = std::array<std::uint8_t, 4>;

inline Image make_image(int width, int height, const std::function<Texel(int, int)>& texel) {
  Image image{.width = width, .height = height};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const std::uint8_t byte : texel(x, y)) image.rgba.own().push_back(byte);
  return image;
}

}  // namespace asos::test
