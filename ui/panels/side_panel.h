#pragma once

#include "ui/panels/controls.h"
#include "ui/panels/panels.h"
#include "ui/ui_state.h"

namespace asos::ui {

class SkyReader;
class SplitCheck;
class ViewStudy;

/// The background jobs that the panel's sections start.
struct PanelJobs {
  const SplitForecast& forecast;
  SkyReader& sky_reader;
  EqualTimeJob& equal_time;
  const SplitCheck& check;
  ViewStudy& study;
};

/// The comparison with a snapshot, with another method in the same CPU time, or with the reference.
void compare_panel(Controls& controls, const Previewer& previewer, UiState& state,
                   const PanelJobs& jobs);

/// Draws all sections below each other into the current Dear ImGui window.
void side_panel(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs);

}  // namespace asos::ui
