#pragma once

#include <array>

namespace asos::ui {

/// Tabs of the panel.
enum class PanelTab {
  antialias,
  scene,
  measure,
  all,  ///< all three, for a search
};

/// The names in the file of settings, in the order of the values.
inline constexpr std::array panel_tab_names{"antialias", "scene", "measure", "all"};

}  // namespace asos::ui
