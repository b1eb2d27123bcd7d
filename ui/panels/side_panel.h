#pragma once

#include "ui/panels/controls.h"
#include "ui/panels/panels.h"
#include "ui/ui_state.h"

namespace asos::ui {

class SkyReader;
class SplitCheck;
class ViewStudy;

/// What the panel's sections ask to be done in the background.
struct PanelJobs {
  const SplitForecast& forecast;
  SkyReader& sky_reader;
  EqualTimeJob& equal_time;
  const SplitCheck& check;
  ViewStudy& study;
};

/// All sections, one below the other, in the current Dear ImGui window.
void side_panel(Controls& controls, Previewer& previewer, UiState& state, const PanelJobs& jobs);

}  // namespace asos::ui
