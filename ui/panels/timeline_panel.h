#pragma once

#include "ui/panels/controls.h"
#include "ui/playback.h"
#include "ui/window_layout.h"

namespace asos::ui {

/// Chooses and plays the file's animations; nothing if it has none.
void timeline_panel(Controls& controls, Playback& playback, RenderSettings& settings,
                    bool under_picture);
/// One row under the picture: play, single frames and the time.
void timeline_row(Controls& controls, Playback& playback);
/// A button over the picture until an animation of the file was played first.
void play_button(Controls& controls, Playback& playback, const WindowRect& picture);

}  // namespace asos::ui
