#pragma once

#include "ui/display_settings.h"
#include "ui/frames.h"
#include "ui/legend_strip.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"
#include "ui/shown_progress.h"
#include "ui/split_forecast.h"
#include "ui/window_look.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

// One panel per file. Each draws its widgets into the current Dear ImGui window and edits its
// arguments; the previewer detects changes itself.

/// The controls that the bar under the picture has room for. The panel has the others.
struct BarParts {
  bool splitting = false;  ///< EPS and MAX
  bool method = false;
  bool exposure = false;
  bool timeline = false;  ///< play, single frames and time
};

/// Explains MAX while it is turned.
struct MaxTurn {
  bool turned = false;
  std::string words;  ///< its effect on the picture; empty: not asked for, or not known yet

  /// Returns a tooltip with the words below.
  [[nodiscard]] std::string added_to(const char* tooltip) const {
    return words.empty() ? std::string(tooltip) : std::string(tooltip) + "\n" + words;
  }
};
/// Call after the slider of MAX, with its name.
void explain_turned_max(Controls& controls, const char* slider, MaxTurn& turn);

/// The methods that can render the scene with these settings; without a scene, those that can
/// render any scene.
[[nodiscard]] std::vector<Method> methods_for(const RenderSettings& settings,
                                              const RenderScene* scene);
/// A list of these methods, each with a line about it.
void method_list(Controls& controls, const char* name, RenderSettings& settings,
                 const RenderScene* scene);
void antialiasing_panel(Controls& controls, Previewer& previewer, const SplitForecast& forecast,
                        const BarParts& bar, const CauseCounts& causes, MaxTurn& turn);
/// Rarely changed settings of the method.
void advanced_panel(Controls& controls, Previewer& previewer);
/// Hides controls of shadows that `scene` does not need.
void shadows_panel(Controls& controls, RenderSettings& settings, const RenderScene* scene);
/// Rules of shadows and lights that the papers compare.
void shadow_rules(Controls& controls, RenderSettings& settings, const RenderScene* scene);
/// How curved mirrors reflect.
void curved_mirror_controls(Controls& controls, RenderSettings& settings);

/// Pause, stop, and the limits of refinement. `marks_part`: the next drag in the picture marks the
/// part to refine first.
void refinement_panel(Controls& controls, Previewer& previewer, bool& marks_part);

/// The state of the lights panel.
struct LightChoice {
  int selected = -1;       ///< -1: none
  bool show_marks = true;  ///< in the picture, while a light is selected
  bool keep_power = true;  ///< keep the power of flat lights whose size changes
  std::string find;        ///< text that the listed lights' names contain
  std::string error;       ///< why a face could not become a light
};
/// The pixel that was clicked in the picture, and the picture's exposure in stops.
struct PointedAt {
  std::optional<glm::ivec2> pixel;
  float exposure_ev = 0.0f;
};
void lights_panel(Controls& controls, Previewer& previewer, LightChoice& choice,
                  const PointedAt& at);

/// Keeps the picture as a snapshot if there is room. Returns a message: "Kept 2: ASOS, EPS 1/256".
std::string keep_snapshot(Frames& frames, const Previewer& previewer);
/// Method and time of the current picture: "ASOS, 18 s", "ASOS, 22 % done".
[[nodiscard]] std::string picture_words(const PreviewRender& render);

void display_panel(Controls& controls, DisplaySettings& display, const BarParts& bar);
/// The titles of the layers in the order of Layer; the first is that of the picture.
[[nodiscard]] std::vector<std::string> layer_titles();
/// Shows the next layer of the list, or the one before it (`by` -1); the picture is one of them.
void show_next_layer(DisplaySettings& display, int by);
[[nodiscard]] const char* layer_title(const DisplaySettings& display);
void camera_panel(Controls& controls, Previewer& previewer);
/// Settings of the window itself.
void window_panel(Controls& controls, WindowLook& look);
void scene_panel(Controls& controls, const RenderScene& scene, const RenderSettings& settings,
                 double load_seconds);
/// `statistics` covers `finished_share` of the pixels, 0 to 1: those that are final.
void statistics_panel(Controls& controls, const RenderStatistics& statistics,
                      const RenderSettings& settings, const RenderScene& scene,
                      double finished_share);
/// Warnings about the file that affect the picture; nothing if there are none.
void warnings_panel(Controls& controls, const SceneNotes& notes, OpenScene& scene);
/// A button that lets the scene read files outside its asset root; nothing if no file was refused.
/// `width`: see Controls::button.
void asset_root_button(Controls& controls, OpenScene& scene, float width);

/// The line below the picture: the current activity with its remaining time, or `message`.
struct StatusLine {
  std::string message;  ///< replaces the progress if not empty
  int zoom = 1;
  std::optional<glm::ivec2> pixel;  ///< the hovered pixel
  DisplayTransform display;
  double fraction = 0.0;  ///< see ShownProgress
  std::string names;      ///< of the object and the material under the pointer; empty: none
  std::string layer{};    ///< values of the shown layer under the pointer; empty: none
};
void progress_panel(Controls& controls, const Previewer& previewer, const StatusLine& status);

}  // namespace asos::ui
