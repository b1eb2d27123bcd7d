#pragma once

#include "renderer/film/layer_colours.h"
#include "ui/error_map.h"
#include "ui/max_effect.h"
#include "ui/panels/controls.h"
#include "ui/panels/panels.h"
#include "ui/picture_job.h"
#include "ui/pixel_report.h"
#include "ui/previewer.h"
#include "ui/save_choice.h"
#include "ui/ui_state.h"
#include "ui/window_layout.h"

#include <glm/glm.hpp>
#include <imgui.h>

#include <optional>

namespace asos::ui {

/// The area of the window that shows the picture.
struct PictureArea {
  WindowRect rect;
  float scale = 1.0f;  ///< framebuffer pixels per window unit
};
/// Where a point of the picture lies in the window; `pixel`: in pixels from the upper left.
[[nodiscard]] ImVec2 place_of(glm::vec2 pixel, const PictureView& view, const PictureArea& area);
/// Handles input in the picture: mouse, wheel and keys move the camera and the picture; a click
/// picks a pixel.
void picture_area(Controls& controls, Previewer& previewer, UiState& state,
                  const PictureArea& area);
/// Two rows below the picture: layers, method, EPS and MAX, exposure and zoom; or one row with
/// layers, EPS and MAX in a small window.
void picture_bar(Controls& controls, Previewer& previewer, UiState& state);
/// Returns the controls that fit into a bar of this size.
[[nodiscard]] BarParts bar_parts(glm::vec2 size);

/// Axes in the upper right corner of a large picture. A click on an end looks along it; a drag
/// orbits.
void axes_widget(Controls& controls, Viewpoint& viewpoint, const PictureArea& area);

/// Whether the camera is moving because keys are held, which needs continuous frames.
[[nodiscard]] bool flying();

/// Draws the lights' marks over the picture, to select and to move lights.
void light_marks(Controls& controls, Previewer& previewer, LightChoice& choice,
                 const PictureView& view, const PictureArea& area);

/// Data about the picked pixel; null: not known, or not yet.
struct PixelFacts {
  const PixelReport* report = nullptr;
  const SplitFindings* findings = nullptr;  ///< for this picture, with a reference
  SurfaceNames names{};
};
/// Shows the data of the picked pixel: values, errors, cost, how it was split and why splitting
/// stopped.
void pixel_panel(Controls& controls, const Previewer& previewer, UiState& state,
                 const PixelFacts& facts, const PictureArea& area);
/// Marks the pixels that MAX ended, and circles the worst ones.
void max_marks(const MaxEffect& effect, const PictureView& view, const PictureArea& area);
/// A bar in the lower right corner of a large picture with its length at the camera's pivot, for
/// glTF files.
void scale_bar(Controls& controls, const Previewer& previewer, const PictureView& view,
               const PictureArea& area);
/// Frames the part of the picture that is refined first, with a button that ends this.
void first_part_mark(Controls& controls, PreviewRender& render, const PictureView& view,
                     const PictureArea& area);
/// Refines the part around the hovered pixel first; the whole picture again if there is a part.
void refine_here_first(UiState& state, PreviewRender& render);
/// Marks the picked pixel, and draws the edges of the hit list over the picture.
void picked_mark(const PixelReport* report, const UiState& state, const PictureArea& area);
/// Writes the displayed red, green and blue, 0 to 255, into pixels zoomed to 24x and more.
void pixel_numbers(Controls& controls, const Film& film, const DisplayTransform& display,
                   const PictureView& view, const PictureArea& area);
/// The draggable line of a wipe.
void wipe_line(Controls& controls, Frames& frames, const PictureView& view,
               const Previewer& previewer, const PictureArea& area);

/// Shows the bounding box of a scene that is being loaded, or rendered for the first time, over the
/// dimmed previous picture. Draws into the current window. Scenes that load within
/// `loading_box_delay` seconds show none, since it would only flicker.
inline constexpr double loading_box_delay = 0.05;
void loading_box(const Previewer& previewer, const PictureArea& area);

/// Notices over the picture: an error, the file being loaded, or the invitation to open a scene.
void notices(Controls& controls, OpenScene& scene, const WindowRect& area);

/// The legend of the split map, over the picture's lower left or right corner while the map is
/// shown. Returns true if the button to explain a pixel was pressed.
struct MapFacts {
  int max_level = 0;
  bool unfinished = false;  ///< some pixels are predicted or not final yet
  CauseCounts causes{};
};
[[nodiscard]] bool split_legend(Controls& controls, const DisplaySettings& display,
                                const MapFacts& map, const WindowRect& area, bool at_right);

/// Data for the legend of an error against the reference.
struct ErrorFacts {
  int samples = 0;        ///< samples per pixel of the reference; 0: there is none yet
  bool finished = false;  ///< the picture is finished
  std::optional<ErrorSummary> summary{};  ///< of the finished picture
};
/// The name of the picture that a comparison shows, and its scale, at the lower left.
void comparison_legend(Controls& controls, const Frames& frames, const ErrorFacts& facts,
                       const WindowRect& area);

/// The name of the layer that is shown, and what its colours mean, at the lower left.
struct LayerFacts {
  Layer layer = Layer::depth;
  LayerScale scale;
  bool rendered = true;  ///< the method renders the layer
};
void layer_legend(Controls& controls, const LayerFacts& facts, const WindowRect& area);

/// Why a pixel was split, in a sentence.
[[nodiscard]] const char* words_of(SplitCause cause);

void help_overlay(Controls& controls, UiState& state, const WindowRect& area);
/// The dialog that opens a file or a built-in scene.
void open_dialog(Controls& controls, UiState& state, Previewer& previewer);

/// Properties of what can be saved.
struct SaveFacts {
  glm::ivec2 shown{0};        ///< size of the picture in the window
  double clip_seconds = 0.0;  ///< length of the animation; 0: there is none
};
/// The dialog that saves a picture: content, size and path.
void save_dialog(Controls& controls, SaveChoice& choice, const SaveFacts& facts);
/// Shows the progress of a picture that is saved in the background. Returns true to cancel it.
[[nodiscard]] bool saving_notice(Controls& controls, const PictureJob& job, const WindowRect& area);

/// Handles the keys that work while no text is typed.
void handle_shortcuts(UiState& state, Previewer& previewer);

}  // namespace asos::ui
