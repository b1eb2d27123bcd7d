#pragma once

#include "renderer/film/layer_colours.h"
#include "ui/panels/controls.h"
#include "ui/panels/panels.h"
#include "ui/picture_job.h"
#include "ui/pixel_report.h"
#include "ui/previewer.h"
#include "ui/save_choice.h"
#include "ui/ui_state.h"
#include "ui/window_layout.h"

#include <glm/glm.hpp>

namespace asos {

/// Where the picture is shown.
struct PictureArea {
  WindowRect rect;
  float scale = 1.0f;  ///< framebuffer pixels for each window unit
};
/// The area that shows the picture: mouse, wheel and keys move the camera and the picture, a click
/// picks a pixel.
void picture_area(Controls& controls, Previewer& previewer, UiState& state,
                  const PictureArea& area);
/// Two rows under the picture: its layers, method, EPS and MAX, exposure and zoom; or one with
/// layers, EPS and MAX where there is little room.
void picture_bar(Controls& controls, Previewer& previewer, UiState& state);

/// Whether keys are held that keep the camera moving, so that the next frame is due at once.
[[nodiscard]] bool flying();

/// The lights' marks over the picture, to select and to move them by.
void light_marks(Controls& controls, Previewer& previewer, LightChoice& choice,
                 const PictureView& view, const PictureArea& area);

/// Findings about the picked pixel; null where it is not known, or not yet.
struct PixelFacts {
  const PixelReport* report = nullptr;
  const SplitFindings* findings = nullptr;  ///< of the picture: holds a reference
  std::string names{};                      ///< of the object and the material; empty: none
};
/// The facts known of the picked pixel: values, errors, cost, how it was split and why it stopped.
void pixel_panel(Controls& controls, const Previewer& previewer, UiState& state,
                 const PixelFacts& facts, const PictureArea& area);
/// Where the picked pixel is, and the boundaries of the hit list, over the picture.
void picked_mark(const PixelReport* report, const UiState& state, const PictureArea& area);
/// The line of a wipe, to be dragged.
void wipe_line(Controls& controls, Frames& frames, const PictureView& view, const Film& film,
               const PictureArea& area);

/// Notices over the picture: the error to read and copy, what is being loaded, or the invitation
/// to open something.
void notices(Controls& controls, OpenScene& scene, const WindowRect& area);

/// What the split map's colours mean, over the picture while the map is shown, at its lower left or
/// right. True: a pixel of it is to be explained.
struct MapFacts {
  int max_level = 0;
  bool unfinished = false;  ///< pixels are predicted, or not final yet
};
[[nodiscard]] bool split_legend(Controls& controls, const DisplaySettings& display,
                                const MapFacts& map, const WindowRect& area, bool at_right);

/// The scale of the layer Error, at the lower left of the picture.
struct ErrorFacts {
  int samples = 0;        ///< of a pixel of the reference; 0: there is none yet
  bool finished = false;  ///< the picture is
};
void error_legend(Controls& controls, const ErrorFacts& facts, const WindowRect& area);

/// The name of the layer that is shown, and what its colours mean, at the lower left.
struct LayerFacts {
  Layer layer = Layer::depth;
  LayerScale scale;
  bool rendered = true;  ///< by the method
};
void layer_legend(Controls& controls, const LayerFacts& facts, const WindowRect& area);

/// Why a pixel was split, in a sentence.
[[nodiscard]] const char* words_of(SplitCause cause);

void help_overlay(UiState& state, const WindowRect& area);
/// Asks for a path or a built-in scene and opens it.
void open_dialog(Controls& controls, UiState& state, Previewer& previewer);

/// What can be saved.
struct SaveFacts {
  glm::ivec2 shown{0};        ///< the size of the picture in the window
  double clip_seconds = 0.0;  ///< of the animation; 0: there is none
};
/// Asks for the part of the picture to save, its size and its path.
void save_dialog(Controls& controls, SaveChoice& choice, const SaveFacts& facts);
/// How far the picture is that is being saved in the background. True: it is to be stopped.
[[nodiscard]] bool saving_notice(Controls& controls, const PictureJob& job, const WindowRect& area);

/// Keys that work while no text is typed.
void handle_shortcuts(UiState& state, Previewer& previewer);

}  // namespace asos
