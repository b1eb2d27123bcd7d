#pragma once

#include "ui/panels/controls.h"
#include "ui/previewer.h"

namespace asos::ui {

/// State of the section Lens.
struct LensState {
  bool click_to_focus = false;  ///< the next click in the picture sets the focus
};

/// Controls of depth of field for a perspective camera.
void lens_panel(Controls& controls, Previewer& previewer, LensState& choice);

}  // namespace asos::ui
