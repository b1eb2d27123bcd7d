#pragma once

#include "ui/display_settings.h"
#include "ui/legend_strip.h"
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

/// The window's own state; scene and settings are in the previewer.
struct UiState {
  DisplaySettings display;
  WindowLook look;
  BarParts bar;  ///< what the bar shows in this frame
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
  std::optional<glm::ivec2> clicked;  ///< the pixel that was clicked last
  std::optional<glm::ivec2> picked;   ///< the pixel that is inspected
  int picked_pyray = -1;           ///< index of its pyray that is inspected; -1: the pixel itself
  bool show_boundaries = false;    ///< draws all edges of the view over the picture
  std::optional<int> shown_level;  ///< of the picked pixel's splitting; none: all levels
  std::optional<glm::ivec2> hovered;  ///< the pixel under the pointer
  bool turns_surroundings = false;    ///< a drag begun with Shift rotates the surroundings
  Frames frames;
  CauseCounts causes;  ///< of the picture
  /// Fraction of the pixels that are split, 0 to 1: see shown_split_share.
  std::optional<double> split_share;
  MaxTurn max_turn;
  bool marks_part = false;   ///< the next drag in the picture marks the part to refine first
  bool show_before = false;  ///< shows the picture of the last finished EPS and MAX
  bool show_panel = true;
  PanelTab tab = PanelTab::antialias;
  std::string search;               ///< text to find in the panel's controls, on all tabs
  bool focus_search = false;        ///< move the keyboard focus to the search
  bool focus_panel = false;         ///< move the keyboard focus to the panel, or back from it
  bool watch = false;               ///< reload the scene's file when it changes
  std::vector<std::string> recent;  ///< see StoredSettings
  bool show_help = false;
  bool show_open = false;
  FileBrowser browser;
  bool screenshot_requested = false;
  bool copy_requested = false;  ///< copy the displayed picture to the clipboard
  SaveSceneChoice save_scene;
  SaveChoice save;
  QuitChoice leaving;
  OpenChoice opening;
  bool tour_asked = false;      ///< start or restart the tour
  bool popup_was_open = false;  ///< in the last frame: Escape closes only the popup
  bool forget = false;          ///< restore the window's default settings
  std::string said;             ///< set by a key or a panel; becomes the message
  std::string message;          ///< shown in the status line until `message_until_seconds`
  double message_until_seconds = 0.0;

  /// The pixel whose object, light or material is meant.
  [[nodiscard]] std::optional<glm::ivec2> pointed() const { return picked ? picked : clicked; }
  /// Whether a layer of the film or a surface property replaces the picture.
  [[nodiscard]] bool shows_layer() const {
    return display.layer.has_value() || surfaces.property.has_value();
  }
  /// Shows the picture again instead of its difference or error.
  void leave_difference() {
    if (frames.comparison >= Comparison::difference) frames.show_picture();
  }
  /// Shows the picture again instead of a layer.
  void leave_layer() {
    display.layer.reset();
    surfaces.property.reset();
  }
};

}  // namespace asos::ui
