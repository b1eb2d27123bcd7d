#pragma once

#include "renderer/settings/settings.h"
#include "renderer/world/render_features.h"
#include "ui/chosen_look.h"
#include "ui/scene_loader.h"

namespace asos::ui {

struct ViewerOptions {
  SceneSource source{"builtin:office"};  ///< opened in the background
  /// Initial settings. The window tries to open with a picture of this width and height; afterwards
  /// the picture follows the window.
  RenderSettings settings;
  bool own_size = false;  ///< the command line sets the size; the remembered one is ignored
  ChosenLook own_look;    ///< the parts of the look that the command line sets
  RenderFeatures forced;  ///< see prepare
};

/// Opens the window and runs until the user closes it. Returns the exit code: 0, or 1 if no window
/// can be opened, with the reason on stderr. Errors of scenes appear in the window. Main thread
/// only.
[[nodiscard]] int run_viewer(const ViewerOptions& options);

}  // namespace asos::ui
