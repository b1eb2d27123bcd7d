#pragma once

#include "renderer/geometry/view.h"

#include <cstdint>
#include <vector>

namespace asos::ui {

/// Reads `area` of the current framebuffer, which is `height` pixels high, as rows of RGB bytes
/// from the top. `area` counts from the top left. Call before the framebuffer is presented.
[[nodiscard]] std::vector<std::uint8_t> read_framebuffer(const PixelRect& area, int height);

}  // namespace asos::ui
