#pragma once

#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A request to quit.
struct QuitChoice {
  bool asked = false;       ///< by Ctrl+Q or the window's close button
  bool after_save = false;  ///< quit once the picture being saved is complete
  bool quit = false;        ///< confirmed: the window closes
};

/// Quits at once if `losses` is empty; otherwise lists them and asks. `saving`: a picture is being
/// saved; the user may wait for it.
void quit_dialog(Controls& controls, QuitChoice& choice, const std::vector<std::string>& losses,
                 bool saving);

}  // namespace asos::ui
