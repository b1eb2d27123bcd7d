#pragma once

#include "ui/panels/controls.h"
#include "ui/playback.h"

namespace asos::ui {

/// Chooses and plays the file's animations; nothing if it has none.
void timeline_panel(Controls& controls, Playback& playback, RenderSettings& settings);

}  // namespace asos::ui
