#pragma once

#include "ui/panels/equal_time_panel.h"
#include "ui/panels/overlays.h"

namespace asos::ui {

/// Shows the tour's current card over the picture; starts the tour if requested.
void tour_panel(Controls& controls, Previewer& previewer, UiState& state, EqualTimeJob& equal_time,
                const PictureArea& area, double now_seconds);
/// Seconds until the card changes by itself; none: it does not.
[[nodiscard]] std::optional<double> seconds_to_card(const UiState& state, double now_seconds);

}  // namespace asos::ui
