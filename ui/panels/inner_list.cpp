#include "ui/panels/inner_list.h"

#include <imgui.h>

namespace asos::ui {

InnerList::InnerList(const char* name, glm::vec2 size) {
  ImGuiStorage& of_panel = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID(name);
  const bool clicked = of_panel.GetBool(id);
  ImGui::BeginChild(name, {size.x, size.y}, false,
                    clicked ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollWithMouse);
  of_panel.SetBool(id, ImGui::IsWindowFocused());
}

InnerList::~InnerList() {
  ImGui::EndChild();
}

}  // namespace asos::ui
