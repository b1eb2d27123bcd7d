#pragma once

#include <glm/glm.hpp>

namespace asos::ui {

/// A rectangle of the window, in window coordinates, y down.
struct WindowRect {
  glm::vec2 lo, size;
};

/// Where the parts of the window lie. They cover it without overlapping.
struct WindowLayout {
  WindowRect picture, status;
  WindowRect bar;    ///< between these; without area where it is not shown
  WindowRect panel;  ///< without area where it is not shown

  /// The panel stands beside the picture, as wide as its texts need; below it in a window that is
  /// too narrow for both. `em`: the height of text.
  [[nodiscard]] static WindowLayout of(glm::vec2 window, float em, bool show_panel,
                                       bool show_bar = false);
};

/// Whether a card of the tour and the panel about a pixel find room in the picture, side by side or
/// one above the other, or that panel below the picture.
[[nodiscard]] bool has_room_for_tour(const WindowLayout& layout, float em);

/// The scale of text that a window of this width has room for: the one that was asked for, or less,
/// in steps of an eighth, where the panel's texts would be cut; but no less than 1.
[[nodiscard]] float fitting_text_scale(float asked, float window_width);

}  // namespace asos::ui
