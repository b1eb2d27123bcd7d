#pragma once

#include "ui/theme.h"

namespace asos::ui {

/// How a person wants the window to look.
struct WindowLook {
  static constexpr float least_scale = 0.5f, most_scale = 3.0f;

  theme::Look theme = theme::Look::dark;
  float scale = 1.0f;    ///< scale of text and controls, times the screen's
  bool show_bar = true;  ///< under the picture

  bool operator==(const WindowLook&) const = default;
};

}  // namespace asos::ui
