#include "ui/panels/save_scene_dialog.h"

#include "ui/input.h"
#include "ui/theme.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace asos::ui {

namespace {

bool has_scene_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".glb" || ending == ".gltf";
}

// Warns about the path. Always takes a line, so that nothing moves.
void path_words(const std::string& path) {
  std::error_code ignored;
  const char* words = " ";
  if (!has_scene_ending(path))
    words = "The name has to end in .glb or .gltf.";
  else if (std::filesystem::exists(path, ignored))
    words = "File exists and will be replaced.";
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::warning));
  ImGui::TextUnformatted(words);
  ImGui::PopStyleColor();
}

}  // namespace

void save_scene_dialog(Controls& controls, SaveSceneChoice& choice, bool hides_objects) {
  constexpr const char* title = "Save scene as";
  if (choice.show && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.4f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(34.0f * em, 0.9f * window.x), 0.0f});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize))
    return;
  ImGui::TextWrapped("Writes a copy of the scene with your lights and DFRs.");
  if (hides_objects) ImGui::TextWrapped("Hidden objects are left out.");
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputText("##scene file", &choice.path);
  controls.placed("Scene file", "Path of the file, .glb or .gltf.", Controls::Use::edits);
  path_words(choice.path);
  const bool save = controls.button("Save scene", "Write in the background.", 8.0f * em) &&
                    has_scene_ending(choice.path);
  ImGui::SameLine();
  const bool cancelled = controls.button("Cancel", "Close without saving (Esc).", 6.0f * em) ||
                         ImGui::IsKeyPressed(static_cast<int>(Key::escape), false);
  choice.asked = save;
  if (save || cancelled) {
    choice.show = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace asos::ui
