#include "renderer/files/printable.h"
#include "renderer/scene/builtin.h"
#include "ui/panels/dialog.h"
#include "ui/panels/named_like.h"
#include "ui/panels/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace asos::ui {

namespace {

// The folder of the open scene, or the current directory.
std::filesystem::path first_folder(const Previewer& previewer) {
  std::error_code error;
  const RenderScene* scene = previewer.scene().get();
  if (scene && std::filesystem::is_regular_file(scene->geometry->source, error))
    return std::filesystem::path(scene->geometry->source).parent_path();
  return std::filesystem::current_path(error);
}

std::string recent_list(Controls& controls, const std::vector<std::string>& recent,
                        const std::string& filter) {
  std::string chosen;
  ImGui::TextDisabled("Recent");
  if (recent.empty()) ImGui::TextDisabled("(none)");
  for (std::size_t i = 0; i < recent.size(); ++i) {
    const std::string name = printable(std::filesystem::path(recent[i]).filename().string());
    if (!named_like(name, filter)) continue;
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_DontClosePopups))
      chosen = recent[i];
    ImGui::PopID();
    controls.placed("Recent/" + std::to_string(i + 1), recent[i].c_str(), Controls::Use::edits);
  }
  return chosen;
}

// The typed text without the prefix of built-in scenes.
std::string builtin_name(const std::string& typed) {
  constexpr std::string_view prefix = "builtin:";
  return typed.starts_with(prefix) ? typed.substr(prefix.size()) : typed;
}

std::string builtin_list(Controls& controls, const std::string& filter) {
  std::string chosen;
  ImGui::TextDisabled("Built-in scenes");
  for (const BuiltinScene& scene : builtin_scenes()) {
    if (!named_like(scene.name, filter)) continue;
    if (ImGui::Selectable(scene.name.c_str(), false, ImGuiSelectableFlags_DontClosePopups))
      chosen = "builtin:" + scene.name;
    controls.placed("Built-in/" + scene.name, scene.summary.c_str(), Controls::Use::edits);
  }
  return chosen;
}

// Recent files and built-in scenes side by side, filtered by the typed text.
std::string known_scenes(Controls& controls, const UiState& state, float height) {
  std::string chosen;
  const std::string filter = state.browser.filter();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  ImGui::BeginChild("recent", {width, height});
  chosen = recent_list(controls, state.recent, filter);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("built-in", {width, height});
  if (const std::string builtin = builtin_list(controls, builtin_name(filter)); !builtin.empty())
    chosen = builtin;
  ImGui::EndChild();
  return chosen;
}

// Returns the first recent file or built-in scene that matches `typed`: Enter opens it if the
// folder has no match. Returns `typed` if there is none.
std::string known_like(const UiState& state, const std::string& typed) {
  for (const std::string& file : state.recent)
    if (named_like(printable(std::filesystem::path(file).filename().string()), typed)) return file;
  const std::string name = builtin_name(typed);
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  const auto exact = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const BuiltinScene& scene) { return scene.name == name; });
  const auto like =
      exact != scenes.end()
          ? exact
          : std::find_if(scenes.begin(), scenes.end(),
                         [&](const BuiltinScene& scene) { return named_like(scene.name, name); });
  return like == scenes.end() ? typed : "builtin:" + like->name;
}

}  // namespace

void open_dialog(Controls& controls, UiState& state, Previewer& previewer) {
  constexpr const char* title = "Open a scene";
  if (state.show_open && !ImGui::IsPopupOpen(title)) state.browser.begin(first_folder(previewer));
  const Dialog dialog(title, state.show_open, 52.0f, 0.5f);
  if (!dialog.open()) return;
  const float em = ImGui::GetFontSize();
  // Limits that keep the dialog within the window.
  constexpr float others_em = 14.0f, least_em = 3.0f, most_em = 34.0f, known_share = 0.35f;
  const float room =
      std::clamp(ImGui::GetIO().DisplaySize.y - others_em * em, least_em * em, most_em * em);
  std::string chosen = browse_files(controls, state.browser, (1.0f - known_share) * room);
  if (const std::string known = known_scenes(controls, state, known_share * room); !known.empty())
    chosen = known;

  ImGui::Spacing();
  if (controls.button("Open", "Open the chosen or typed file (Enter).", 6.0f * em))
    chosen = state.browser.take_entered();
  if (!chosen.empty() && chosen == state.browser.typed) chosen = known_like(state, chosen);
  const bool cancelled = dialog.cancelled(controls, "Close (Esc).");
  if (!chosen.empty()) {
    std::error_code ignored;
    const std::filesystem::path file = chosen;
    if (std::filesystem::is_regular_file(file, ignored)) state.browser.folder = file.parent_path();
    state.opening = {chosen};
  }
  if (!chosen.empty() || cancelled) {
    state.show_open = false;
    dialog.close();
  }
}

}  // namespace asos::ui
