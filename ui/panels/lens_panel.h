#pragma once

#include "ui/panels/controls.h"
#include "ui/previewer.h"

namespace asos::ui {

/// What the section Lens waits for.
struct LensState {
  bool click_to_focus = false;  ///< the next click into the picture sets the focus
};

/// Depth of field of a perspective camera.
void lens_panel(Controls& controls, Previewer& previewer, LensState& choice);

}  // namespace asos::ui
