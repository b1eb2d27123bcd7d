#pragma once

#include "ui/display_settings.h"
#include "ui/panel_tab.h"
#include "ui/panels/check_panel.h"
#include "ui/panels/equal_time_panel.h"
#include "ui/panels/file_browser.h"
#include "ui/panels/lens_panel.h"
#include "ui/panels/open_question.h"
#include "ui/panels/outline_panel.h"
#include "ui/panels/panels.h"
#include "ui/panels/quit_dialog.h"
#include "ui/panels/reflections_panel.h"
#include "ui/panels/save_scene_dialog.h"
#include "ui/panels/sky_panel.h"
#include "ui/panels/study_panel.h"
#include "ui/picture_view.h"
#include "ui/save_choice.h"
#include "ui/surface_viewer.h"
#include "ui/tour.h"
#include "ui/window_look.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// The window's own state, beside the previewer's scene and settings.
struct UiState {
  DisplaySettings display;
  WindowLook look;
  Tour tour;
  PictureView view;
  StudyChoice study;
  LightChoice lights;
  LensState lens;
  ReflectionChoice reflections;
  OutlineChoice outline;
  SkyEdit sky;
  CheckChoice check;
  SurfaceChoice surfaces;
  EqualTimeChoice equal_time;
  std::optional<glm::ivec2> picked;  ///< the pixel that was clicked
  int picked_pyray = -1;         ///< the one of its pyrays that is looked at; -1: the pixel itself
  bool show_boundaries = false;  ///< of the hit list, in the picture
  std::optional<int> shown_level;     ///< of the picked pixel's splitting; none: all of it
  std::optional<glm::ivec2> hovered;  ///< the pixel under the pointer
  bool turns_surroundings = false;    ///< the right button's drag does, which Shift began
  Frames frames;
  bool show_error = false;   ///< the error of each pixel in place of the picture
  bool show_before = false;  ///< the last finished EPS and MAX in place of the picture
  bool show_panel = true;
  PanelTab tab = PanelTab::antialias;
  std::string search;               ///< for controls of the panel, whatever its tab
  bool focus_search = false;        ///< the keyboard moves to it
  bool focus_panel = false;         ///< the keyboard moves to the panel, or back from it
  bool watch = false;               ///< load the scene's file again when it changes
  std::vector<std::string> recent;  ///< see StoredSettings
  bool show_help = false;
  bool show_open = false;
  FileBrowser browser;
  bool screenshot_requested = false;
  bool copy_requested = false;  ///< of the picture as it is shown, to the clipboard
  SaveSceneChoice save_scene;
  SaveChoice save;
  QuitChoice leaving;
  OpenChoice opening;
  bool tour_asked = false;      ///< to be begun, or begun again
  bool popup_was_open = false;  ///< in the frame before: Escape closes that, and nothing else
  bool forget = false;          ///< go back to how the window was at first
  std::string said;             ///< by a key or a panel, to become the message
  std::string message;          ///< in the status line, until `message_until_seconds`
  double message_until_seconds = 0.0;
};

}  // namespace asos::ui
