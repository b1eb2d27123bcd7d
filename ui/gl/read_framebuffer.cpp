#include "ui/gl/read_framebuffer.h"

#include "ui/gl/gl.h"

#include <algorithm>
#include <cstddef>

namespace asos::ui {

std::vector<std::uint8_t> read_framebuffer(const PixelRect& area, int height) {
  const std::size_t row = 3 * static_cast<std::size_t>(area.width);
  const auto rows = static_cast<std::size_t>(area.height);
  std::vector<std::uint8_t> bottom_up(row * rows), rgb;
  gl::glPixelStorei(GL_PACK_ALIGNMENT, 1);
  gl::glReadPixels(area.x, height - area.y - area.height, area.width, area.height, GL_RGB,
                   GL_UNSIGNED_BYTE, bottom_up.data());
  rgb.reserve(bottom_up.size());
  for (std::size_t y = rows; y-- > 0;) {
    const auto from = bottom_up.begin() + static_cast<std::ptrdiff_t>(y * row);
    rgb.insert(rgb.end(), from, from + static_cast<std::ptrdiff_t>(row));
  }
  return rgb;
}

}  // namespace asos::ui
