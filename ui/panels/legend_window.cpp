#include "ui/panels/legend_window.h"

#include <imgui.h>

#include <algorithm>

namespace asos::ui {

LegendWindow::LegendWindow(Controls& controls, const char* name, const WindowRect& area,
                           float width_em, float least_height_em, bool at_right)
    : controls_(controls), name_(name) {
  const float em = ImGui::GetFontSize();
  const float width = std::min(width_em * em, area.size.x - em);
  if (width < 8.0f * em || area.size.y < least_height_em * em) return;
  const float left = at_right ? area.lo.x + area.size.x - width - 0.5f * em : area.lo.x + 0.5f * em;
  ImGui::SetNextWindowPos({left, area.lo.y + area.size.y - 0.5f * em}, ImGuiCond_Always,
                          {0.0f, 1.0f});
  ImGui::SetNextWindowSize({width, 0.0f});
  ImGui::SetNextWindowBgAlpha(0.96f);
  window_.emplace(name, OverlayWindow::usual_flags, 0.0f);
}

LegendWindow::~LegendWindow() {
  if (window_) controls_.placed_window(name_);
}

}  // namespace asos::ui
