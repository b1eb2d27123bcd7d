#pragma once

#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A person's wish to leave.
struct QuitChoice {
  bool asked = false;       ///< Ctrl+Q, or the window's own button
  bool after_save = false;  ///< once the picture that is being saved is complete
  bool quit = false;        ///< decided: the window closes
};

/// Decides at once where `losses` is empty; else asks, and names them. `saving`: a picture is being
/// saved, which may be waited for.
void quit_dialog(Controls& controls, QuitChoice& choice, const std::vector<std::string>& losses,
                 bool saving);

}  // namespace asos::ui
