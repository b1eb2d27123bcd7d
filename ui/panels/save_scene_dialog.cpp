#include "ui/panels/save_scene_dialog.h"

#include "ui/panels/dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

namespace asos::ui {

namespace {

bool has_scene_ending(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".glb" || ending == ".gltf";
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
  const bool valid = has_scene_ending(choice.path);
  dialog.path_words(choice.path, valid ? nullptr : "The name has to end in .glb or .gltf.");
  dialog.end_saving(controls, "Save scene", "Write in the background (Enter).", valid, choice);
}

}  // namespace asos::ui
