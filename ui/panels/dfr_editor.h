#pragma once

#include "ui/dfr_curve.h"
#include "ui/panels/controls.h"

#include <optional>

namespace asos::ui {

/// Plots a defocusing ratio and how much a pyray widens by it against the angle of incidence, with
/// points to drag and numbers to type, and shows what the mirror makes of a bar. `usual`: what a
/// double click goes back to. `incidence_rad`: an angle to mark. Whether `dfr` was changed.
bool dfr_editor(Controls& controls, Dfr& dfr, DfrChannel& channel, const Dfr& usual,
                std::optional<double> incidence_rad);

}  // namespace asos::ui
