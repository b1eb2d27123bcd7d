#pragma once

#include "ui/panels/controls.h"
#include "ui/surface_viewer.h"

#include <array>

namespace asos::ui {

/// The keys that show the properties, in the order of SurfaceProperty.
inline constexpr std::array<const char*, surface_properties> surface_keys{"B", "N", "H", "L",
                                                                          "K", "I", "U"};
inline constexpr const char* wireframe_key = "Y";

/// Chooses the property in place of the picture, and the wireframe over it.
void surface_panel(Controls& controls, SurfaceChoice& choice);
/// The name of the chosen property; null: the picture is shown.
[[nodiscard]] const char* surface_title(const SurfaceChoice& choice);
/// Shows a property, or the picture again where it is shown already.
void toggle(SurfaceChoice& choice, SurfaceProperty property);

}  // namespace asos::ui
