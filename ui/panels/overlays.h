#pragma once

#include "ui/panels/controls.h"
#include "ui/previewer.h"
#include "ui/ui_state.h"

#include <glm/glm.hpp>

namespace asos {

/// A rectangle of the window, in window coordinates, y down.
struct WindowRect {
  glm::vec2 lo, size;
};

/// The area that shows the picture: mouse and wheel over it move the camera and the picture. Draws
/// nothing. `framebuffer_scale`: framebuffer pixels for each window unit.
void picture_area(Controls& controls, Previewer& previewer, PictureView& view,
                  const WindowRect& area, float framebuffer_scale);

/// What lies over the picture: the error to read and copy, what is being loaded, or the invitation
/// to open something.
void notices(Controls& controls, Previewer& previewer, const WindowRect& area);

void help_overlay(UiState& state, const WindowRect& area);
/// Asks for a path or a built-in scene and opens it.
void open_dialog(Controls& controls, UiState& state, Previewer& previewer);

/// Keys that work while no text is typed.
void handle_shortcuts(UiState& state, Previewer& previewer);

}  // namespace asos
