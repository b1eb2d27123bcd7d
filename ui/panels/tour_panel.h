#pragma once

#include "ui/panels/equal_time_panel.h"
#include "ui/panels/overlays.h"

namespace asos::ui {

/// The card of the tour that is shown, over the picture; begins the tour where that was asked for.
void tour_panel(Controls& controls, Previewer& previewer, UiState& state, EqualTimeJob& equal_time,
                const PictureArea& area, double now_seconds);
/// When the card changes by itself, in seconds; none: it waits.
[[nodiscard]] std::optional<double> seconds_to_card(const UiState& state, double now_seconds);

}  // namespace asos::ui
