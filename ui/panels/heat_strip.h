#pragma once

#include <imgui.h>

#include <span>
#include <string>

namespace asos::ui {

/// A tick of a colour scale, at `share`, 0 to 1.
struct HeatTick {
  float share;
  std::string text;
};
/// Draws heat_colour from black to white across the window, with the ticks' texts below it.
void heat_strip(std::span<const HeatTick> ticks);

}  // namespace asos::ui
