#include "ui/panels/quit_dialog.h"

#include "ui/input.h"

#include <imgui.h>

#include <algorithm>

namespace asos::ui {

void quit_dialog(Controls& controls, QuitChoice& choice, const std::vector<std::string>& losses,
                 bool saving) {
  constexpr const char* title = "Quit?";
  if (choice.after_save && !saving) choice.quit = true;
  if (choice.asked && losses.empty()) choice.quit = true;
  if (choice.quit) return;
  const bool open = ImGui::IsPopupOpen(title);
  // A second request quits without asking.
  if (choice.asked && open) choice.quit = true;
  if (choice.asked && !open) ImGui::OpenPopup(title);
  choice.asked = false;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.4f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(30.0f * em, 0.9f * window.x), 0.0f});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize))
    return;
  ImGui::TextUnformatted("Quit and lose these changes?");
  ImGui::PushTextWrapPos(0.0f);
  for (const std::string& line : losses) ImGui::BulletText("%s", line.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  choice.quit |= controls.button("Quit", "Close the window (Ctrl+Q again).", 6.0f * em);
  if (saving) {
    ImGui::SameLine();
    if (controls.button("Quit when saved", "Close the window when the picture is complete."))
      choice.after_save = true;
  }
  ImGui::SameLine();
  const bool stay = controls.button("Cancel", "Return to the window (Esc).", 6.0f * em) ||
                    ImGui::IsKeyPressed(static_cast<int>(Key::escape), false);
  if (choice.quit || choice.after_save || stay || losses.empty()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace asos::ui
