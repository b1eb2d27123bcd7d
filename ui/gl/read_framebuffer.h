#pragma once

#include "renderer/geometry/view.h"

#include <cstdint>
#include <vector>

namespace asos::ui {

/// The pixels of the current framebuffer, which is `height` high, in `area`, which is told from the
/// top left: rows of RGB bytes from the top. Call before it is presented.
[[nodiscard]] std::vector<std::uint8_t> read_framebuffer(const PixelRect& area, int height);

}  // namespace asos::ui
