#pragma once

#include "renderer/settings/settings.h"
#include "renderer/world/needs.h"
#include "ui/chosen_look.h"
#include "ui/scene_loader.h"

namespace asos::ui {

struct ViewerOptions {
  SceneSource source{"builtin:office"};  ///< opened in the background
  /// The settings to start with. width and height are the picture's size that the window tries to
  /// offer; from then on the picture follows the window.
  RenderSettings settings;
  bool own_size = false;  ///< the size was asked for, so that the remembered one does not count
  ChosenLook own_look;    ///< what of the settings was asked for
  SceneNeeds forced;      ///< see prepare
};

/// Opens the window and runs until the user closes it. Returns the exit code: 0, or 1 where no
/// window can be opened, with the reason on stderr. Errors of scenes appear in the window. Main
/// thread only.
[[nodiscard]] int run_viewer(const ViewerOptions& options);

}  // namespace asos::ui
