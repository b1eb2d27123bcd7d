#pragma once

#include "ui/panels/controls.h"
#include "ui/playback.h"

namespace asos {

/// Which animation of the file is shown, when, and whether it plays; nothing where it has none.
void timeline_panel(Controls& controls, Playback& playback, RenderSettings& settings);

}  // namespace asos
