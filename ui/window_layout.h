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
  WindowRect bar;       ///< between these; zero area if hidden
  WindowRect timeline;  ///< between picture and bar; zero area if there is no room
  WindowRect panel;     ///< zero area if hidden

  /// Places the panel next to the picture, as wide as its texts need, or below it in a window that
  /// is too narrow for both. Windows below 400 pixels of height have none. `em`: the height of
  /// text.
  [[nodiscard]] static WindowLayout of(glm::vec2 window, float em, bool show_panel,
                                       bool show_bar = false, bool show_timeline = false);
};

/// Whether the tour's card and the pixel panel fit into the picture side by side or one above the
/// other, or the pixel panel fits below the picture.
[[nodiscard]] bool has_room_for_tour(const WindowLayout& layout, float em);

/// The largest text scale at which the panel's texts fit into a window of this width: `asked` or
/// less, in steps of an eighth, but at least 1.
[[nodiscard]] float fitting_text_scale(float asked, float window_width);

}  // namespace asos::ui
