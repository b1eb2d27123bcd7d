#include "ui/panels/open_question.h"

#include "renderer/files/printable.h"
#include "ui/input.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

namespace asos::ui {

namespace {

void open_wanted(OpenScene& scene, OpenChoice& choice) {
  scene.open(choice.wanted);
  choice = {};
}

std::string question(const OpenChoice& choice) {
  return fmt::format("Open {} and lose these changes?",
                     printable(std::filesystem::path(choice.wanted).filename().string()));
}

}  // namespace

void open_question(Controls& controls, OpenScene& scene, OpenChoice& choice,
                   const std::vector<std::string>& losses) {
  constexpr const char* title = "Open another scene?";
  const auto asked = [&] { return !choice.wanted.empty(); };
  if (asked() && losses.empty()) open_wanted(scene, choice);
  if (asked() && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.4f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(30.0f * em, 0.9f * window.x), 0.0f});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize))
    return;
  ImGui::TextWrapped("%s", question(choice).c_str());
  ImGui::PushTextWrapPos(0.0f);
  for (const std::string& line : losses) ImGui::BulletText("%s", line.c_str());
  ImGui::PopTextWrapPos();
  ImGui::TextWrapped("A saved picture (P) or scene (Ctrl+Shift+S) keeps them.");
  ImGui::Spacing();
  const bool open = controls.button("Open", "Open the scene without your changes.", 6.0f * em);
  ImGui::SameLine();
  const bool stay = controls.button("Cancel", "Keep this scene (Esc).", 6.0f * em) ||
                    ImGui::IsKeyPressed(static_cast<int>(Key::escape), false);
  if (open || stay || !asked()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (open && asked()) open_wanted(scene, choice);
  if (stay) choice = {};
}

}  // namespace asos::ui
