#pragma once

#include "ui/panels/overlays.h"
#include "ui/ui_state.h"
#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <optional>

// What explains a pixel must not lie on it. All in window coordinates.

namespace asos::ui {

/// Where a panel that explains a pixel stands, and how high it may grow.
struct PixelPlace {
  enum class Side { left, right, below_picture, above_pixel, below_pixel };
  Side side = Side::left;
  glm::vec2 lo{0.0f};
  float width = 0.0f;
  float most_height = 0.0f;
};

/// Over the panel where that stands below the picture; else at the left of the picture, or at its
/// right; or else above or below the pixel. `em`: the height of text.
[[nodiscard]] PixelPlace place_beside_pixel(glm::vec2 pixel, const WindowRect& picture,
                                            glm::vec2 window, float em);

/// The square that shows a pixel of the picture.
[[nodiscard]] WindowRect shown_pixel(glm::ivec2 pixel, const PictureView& view,
                                     const PictureArea& area);
/// Of the pixel that was picked; none: there is none, or nothing of the picture is seen.
[[nodiscard]] std::optional<PixelPlace> picked_place(const UiState& state, const PictureArea& area,
                                                     float em);

}  // namespace asos::ui
