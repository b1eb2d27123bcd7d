#pragma once

#include "renderer/settings/settings.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// The controls of the background and of the ground.
void background_controls(Controls& controls, RenderSettings& settings);

}  // namespace asos::ui
