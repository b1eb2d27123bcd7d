#pragma once

#include "ui/panels/controls.h"
#include "ui/panels/overlay_window.h"
#include "ui/window_layout.h"

#include <optional>

namespace asos::ui {

/// The Dear ImGui window of a legend in a lower corner of the picture, for as long as it lives.
class LegendWindow {
 public:
  /// `name`: of the legend among the controls. `area`: of the picture. It has no room, and is not
  /// drawn, in areas narrower than 8 em or lower than `least_height_em`.
  LegendWindow(Controls& controls, const char* name, const WindowRect& area, float width_em,
               float least_height_em = 6.0f, bool at_right = false);
  ~LegendWindow();
  LegendWindow(const LegendWindow&) = delete;
  LegendWindow& operator=(const LegendWindow&) = delete;

  [[nodiscard]] bool has_room() const { return window_.has_value(); }

 private:
  Controls& controls_;
  const char* name_;
  std::optional<OverlayWindow> window_;  // none: no room
};

}  // namespace asos::ui
