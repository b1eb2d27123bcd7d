#pragma once

#include "ui/panels/controls.h"
#include "ui/surface_viewer.h"

#include <array>
#include <string>

namespace asos::ui {

/// The keys of the surface properties, in the order of SurfaceProperty.
inline constexpr std::array<const char*, surface_properties> surface_keys{"B", "N", "G", "L", "K",
                                                                          "I", "U", "",  ""};
inline constexpr const char* wireframe_key = "Y";

/// Chooses the surface property to show instead of the picture, and the wireframe.
void surface_panel(Controls& controls, SurfaceChoice& choice);
/// The title of the chosen property; null: the picture is shown.
/// The titles of the properties, with their keys.
[[nodiscard]] std::string surface_entry(int property);
[[nodiscard]] const char* surface_title(const SurfaceChoice& choice);
/// Shows a property; shows the picture again if that property is shown.
void toggle(SurfaceChoice& choice, SurfaceProperty property);

}  // namespace asos::ui
