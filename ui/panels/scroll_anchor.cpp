#include "ui/panels/scroll_anchor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos::ui {

void ScrollAnchor::hold(const Controls& controls) {
  moved_ = false;
  const ImVec2 at = ImGui::GetMousePos();
  const glm::vec2 pointer(at.x, at.y);
  const float scroll = ImGui::GetScrollY();
  const auto found = controls.all().find(name_);
  // A pointer that rests over the panel from the start aims at nothing.
  if (!std::exchange(started_, true)) {
    pointer_ = pointer;
    scroll_ = scroll;
  }
  if (name_.empty() && pointer == pointer_ && scroll == scroll_) return;
  // After moving the pointer or scrolling, the user aims at another control.
  if (pointer != pointer_ || scroll != scroll_ || found == controls.all().end()) {
    take(controls, pointer);
    return;
  }
  const float shift = found->second.lo.y - y_;
  const float target = std::clamp(scroll + shift, 0.0f, ImGui::GetScrollMaxY());
  if (std::abs(target - scroll) < 1.0f) return;
  ImGui::SetScrollY(target);  // from the next frame on
  scroll_ = std::floor(target);
  moved_ = true;
}

// Chooses the control under the pointer, or else the nearest one above it.
void ScrollAnchor::take(const Controls& controls, glm::vec2 pointer) {
  name_.clear();
  pointer_ = pointer;
  scroll_ = ImGui::GetScrollY();
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                              ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))
    return;
  const ImVec2 window = ImGui::GetWindowPos();
  y_ = window.y;
  for (const auto& [name, placed] : controls.all()) {
    const bool here = placed.window == glm::vec2(window.x, window.y);
    if (!here || placed.lo.y > pointer.y || placed.lo.y < y_) continue;
    name_ = name;
    y_ = placed.lo.y;
  }
}

}  // namespace asos::ui
