#pragma once

#include "ui/panels/card_place.h"
#include "ui/panels/overlays.h"
#include "ui/ui_state.h"
#include "ui/window_layout.h"

#include <glm/glm.hpp>

#include <optional>

// Placement of the pixel panel, which must not cover its pixel. All in window coordinates.

namespace asos::ui {

/// Position and maximum height of the pixel panel.
struct PixelPlace {
  enum class Side { left, right, below_picture, above_pixel, below_pixel };
  Side side = Side::left;
  glm::vec2 lo{0.0f};
  float width = 0.0f;
  float most_height = 0.0f;
};

/// Chooses a place: below the picture if there is room, even over the panel; otherwise at the left
/// or right of the picture, otherwise above or below the pixel. `em`: the height of text.
[[nodiscard]] PixelPlace place_beside_pixel(glm::vec2 pixel, const WindowRect& picture,
                                            glm::vec2 window, float em);

/// The square that displays a pixel of the picture.
/// Returns `usual` if the tour's card has room next to it. Otherwise returns the largest rectangle
/// that leaves room for the card and does not cover the pixel.
[[nodiscard]] PixelPlace place_beside_card(const PixelPlace& usual, const WindowRect& pixel,
                                           const WindowRect& picture, const CardHeights& heights,
                                           float em);
[[nodiscard]] WindowRect shown_pixel(glm::ivec2 pixel, const PictureView& view,
                                     const PictureArea& area);
/// The place for the picked pixel's panel; none: no pixel is picked, or the picture is not visible.
[[nodiscard]] std::optional<PixelPlace> picked_place(const UiState& state, const PictureArea& area,
                                                     float em);

}  // namespace asos::ui
