#pragma once

#include "ui/display_settings.h"
#include "ui/panels/study_panel.h"
#include "ui/picture_view.h"

#include <string>

namespace asos {

/// What the window itself remembers, beside the previewer's scene and settings.
struct UiState {
  DisplaySettings display;
  PictureView view;
  StudyChoice study;
  bool show_panel = true;
  bool show_help = false;
  bool show_open = false;
  std::string open_path;  ///< typed into the open dialog
  bool screenshot_requested = false;
  bool quit = false;
  std::string message;  ///< in the status line, until `message_until_seconds`
  double message_until_seconds = 0.0;
};

}  // namespace asos
