#pragma once

#include "ui/display_settings.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

namespace asos {

// One panel a file. Each draws its widgets into the current Dear ImGui window and edits what it is
// given; the previewer notices by itself.

void antialiasing_panel(Controls& controls, RenderSettings& settings);
void display_panel(Controls& controls, DisplaySettings& display, int max_level);
void camera_panel(Controls& controls, Previewer& previewer);
void scene_panel(Controls& controls, const RenderScene& scene, double load_seconds);
void statistics_panel(Controls& controls, const RenderStatistics& statistics,
                      const RenderSettings& settings);

/// The line under the picture: what is going on and for how long still, or `message`.
struct StatusLine {
  std::string message;  ///< shown in place of the progress where not empty
  int zoom = 1;
};
void progress_panel(Controls& controls, const Previewer& previewer, const StatusLine& status);

}  // namespace asos
