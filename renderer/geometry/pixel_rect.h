#pragma once

namespace asos {

/// Pixels, x to the right and y down, from (x, y) inclusive to (x + width, y + height) exclusive.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  bool operator==(const PixelRect&) const = default;
};

}  // namespace asos
