#include "ui/panels/overlay_window.h"

#include <algorithm>

namespace asos::ui {

OverlayWindow::OverlayWindow(const char* name, ImGuiWindowFlags flags, float border) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.3f * ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, border);
  ImGui::Begin(name, nullptr,
               flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
}

OverlayWindow::~OverlayWindow() {
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void place_notice(const WindowRect& picture, float width_em, float height, float anchor) {
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(
      {picture.lo.x + 0.5f * picture.size.x, picture.lo.y + height * picture.size.y},
      ImGuiCond_Always, {0.5f, anchor});
  ImGui::SetNextWindowSize(
      {std::max(std::min(width_em * em, picture.size.x - 2.0f * em), em), 0.0f});
}

}  // namespace asos::ui
