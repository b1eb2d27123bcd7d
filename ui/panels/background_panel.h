#pragma once

#include "renderer/settings/settings.h"
#include "ui/panels/controls.h"

namespace asos::ui {

/// The controls of what is seen where no surface is, and of what the scene stands on.
void background_controls(Controls& controls, RenderSettings& settings);

}  // namespace asos::ui
