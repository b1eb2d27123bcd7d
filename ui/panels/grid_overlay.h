#pragma once

#include "ui/panels/overlays.h"

namespace asos {

/// The step of a grid under something of this radius: 1, 2 or 5 times a power of ten, so that there
/// are some ten squares across it; 0 where it has none.
[[nodiscard]] double grid_step(double radius);

/// A grid through the scene's lowest point and the author's three axes, over the picture; nothing
/// hides it.
void grid_overlay(const Previewer& previewer, const PictureView& view, const PictureArea& area);

}  // namespace asos
