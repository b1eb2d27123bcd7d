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

/// The tabs' names in the settings file, in the order of the enumerators.
inline constexpr std::array panel_tab_names{"antialias", "scene", "measure", "all"};

}  // namespace asos::ui
