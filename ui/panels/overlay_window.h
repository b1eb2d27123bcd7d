#pragma once

#include "ui/window_layout.h"

#include <imgui.h>

namespace asos::ui {

/// A Dear ImGui window over the picture, without title bar or keyboard navigation, drawn during its
/// lifetime.
class OverlayWindow {
 public:
  static constexpr ImGuiWindowFlags usual_flags =
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_AlwaysAutoResize;
  /// `flags`: of size and scroll bars. `border`: width in pixels.
  explicit OverlayWindow(const char* name, ImGuiWindowFlags flags = usual_flags,
                         float border = 1.0f);
  ~OverlayWindow();
  OverlayWindow(const OverlayWindow&) = delete;
  OverlayWindow& operator=(const OverlayWindow&) = delete;
};

/// Places the next window in the centre of the picture's width. `height`: fraction of the picture's
/// height where the fraction `anchor` of the window's height lies.
void place_notice(const WindowRect& picture, float width_em, float height, float anchor);

}  // namespace asos::ui
