#pragma once

#include "ui/dfr_curve.h"
#include "ui/panels/controls.h"

#include <optional>

namespace asos::ui {

/// Plots a defocusing ratio and the widening of a pyray against the angle of incidence, with
/// draggable points and editable numbers, and shows a bar reflected by the mirror. `usual`: the
/// values that a double click restores. `incidence_rad`: an angle to mark. Returns whether `dfr`
/// was changed.
bool dfr_editor(Controls& controls, Dfr& dfr, DfrChannel& channel, const Dfr& usual,
                std::optional<double> incidence_rad);

}  // namespace asos::ui
