#pragma once

#include "ui/display_settings.h"
#include "ui/frames.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"
#include "ui/shown_progress.h"
#include "ui/split_forecast.h"
#include "ui/window_look.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos {

// One panel a file. Each draws its widgets into the current Dear ImGui window and edits what it is
// given; the previewer notices by itself.

/// The methods that can render the scene with these settings; without a scene, those that can
/// render any.
[[nodiscard]] std::vector<Method> methods_for(const RenderSettings& settings,
                                              const RenderScene* scene);
void antialiasing_panel(Controls& controls, Previewer& previewer, const SplitForecast& forecast);
/// Settings of the method that are rarely changed.
void advanced_panel(Controls& controls, Previewer& previewer);
/// Controls of shadows, or of soft shadows, that `scene` does not need are not shown.
void shadows_panel(Controls& controls, RenderSettings& settings, const RenderScene* scene);

/// Pause, stop, and until when a render refines.
void refinement_panel(Controls& controls, Previewer& previewer);

/// The person's choice among the lights.
struct LightChoice {
  int selected = -1;       ///< -1: none
  bool show_marks = true;  ///< in the picture, while one is selected
  bool keep_power = true;  ///< of flat lights whose size is edited
  std::string find;        ///< letters that the names of listed lights hold
  std::string error;       ///< why no light could be made of a face
};
/// `picked`: the pixel that was clicked in the picture.
void lights_panel(Controls& controls, Previewer& previewer, LightChoice& choice,
                  std::optional<glm::ivec2> picked);

/// Frames that were put by, and the current picture beside one of them.
void compare_panel(Controls& controls, const Previewer& previewer, Frames& frames);
/// False where there are enough already.
bool store_frame(Frames& frames, const Previewer& previewer);
/// "Kept 2: ASOS, EPS 1/256", of the newest one.
[[nodiscard]] std::string kept_words(const Frames& frames);

void display_panel(Controls& controls, DisplaySettings& display);
/// Shows the next layer of the list, or the one before it (`by` -1); the picture is one of them.
void show_next_layer(DisplaySettings& display, int by);
[[nodiscard]] const char* layer_title(const DisplaySettings& display);
void camera_panel(Controls& controls, Previewer& previewer);
/// How the window itself looks.
void window_panel(Controls& controls, WindowLook& look);
void scene_panel(Controls& controls, const RenderScene& scene, const RenderSettings& settings,
                 double load_seconds);
/// `finished_share` of the pixels is what `statistics` is about, 0 to 1.
void statistics_panel(Controls& controls, const RenderStatistics& statistics,
                      const RenderSettings& settings, const RenderScene& scene,
                      double finished_share);
/// Remarks that a person should know before trusting the picture; nothing where there are none.
void warnings_panel(Controls& controls, const SceneNotes& notes, OpenScene& scene);
/// A button that lets the scene read files outside of its asset root; nothing where none was
/// refused. `width` as of Controls::button.
void asset_root_button(Controls& controls, OpenScene& scene, float width);

/// The line under the picture: what is going on and for how long still, or `message`.
struct StatusLine {
  std::string message;  ///< shown in place of the progress where not empty
  int zoom = 1;
  std::optional<glm::ivec2> pixel;  ///< the one under the pointer
  DisplayTransform display;
  double fraction = 0.0;  ///< see ShownProgress
  std::optional<TimeEstimate> estimate;
  std::string names;    ///< of the object and the material under the pointer; empty: none
  std::string layer{};  ///< values of the layer that is shown under the pointer; empty: none
};
void progress_panel(Controls& controls, const Previewer& previewer, const StatusLine& status);

}  // namespace asos
