#include "ui/panels/save_scene_dialog.h"

#include "ui/panels/dialog.h"
#include "ui/theme.h"

#include <imgui.h>
#include <imgui_stdlib.h>

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
  const Dialog dialog(title, choice.show, 34.0f);
  if (!dialog.open()) return;
  ImGui::TextWrapped("Writes a copy of the scene with your lights and DFRs.");
  if (hides_objects) ImGui::TextWrapped("Hidden objects are left out.");
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputText("##scene file", &choice.path);
  controls.placed("Scene file", "Path of the file, .glb or .gltf.", Controls::Use::edits);
  path_words(choice.path);
  const bool save = dialog.confirmed(controls, "Save scene", "Write in the background (Enter).") &&
                    has_scene_ending(choice.path);
  const bool cancelled = dialog.cancelled(controls, "Close without saving (Esc).");
  choice.asked = save;
  if (!save && !cancelled) return;
  choice.show = false;
  dialog.close();
}

}  // namespace asos::ui
