#pragma once

#include "ui/open_scene.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// Lists the scenes of a file that has several, to choose one.
void scenes_panel(Controls& controls, OpenScene& scene);

}  // namespace asos::ui
