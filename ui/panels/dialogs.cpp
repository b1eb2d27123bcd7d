#include "renderer/scene/load.h"
#include "ui/input.h"
#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

namespace asos {

namespace {

struct HelpLine {
  const char* input;
  const char* meaning;
};
constexpr std::array help_lines{
    HelpLine{"Left drag", "orbit"},
    HelpLine{"Middle drag, Shift + left drag", "pan"},
    HelpLine{"Wheel", "move closer, farther"},
    HelpLine{"Double click", "orbit about this point"},
    HelpLine{"Right drag, with W A S D Q E", "look around, fly; Shift: faster"},
    HelpLine{"Home, F", "frame the whole scene"},
    HelpLine{"Click", "see how a pixel was split"},
    HelpLine{nullptr, nullptr},
    HelpLine{"Ctrl + wheel, + and -", "zoom into the pixels"},
    HelpLine{"Right drag, zoomed", "move the picture"},
    HelpLine{"1", "back to one to one"},
    HelpLine{"S, X", "store the picture, flip to it and back"},
    HelpLine{"M", "split map"},
    HelpLine{"C", "split map by level, cause, rays, time"},
    HelpLine{"Space", "pause the render, go on"},
    HelpLine{"Ctrl + Z, Ctrl + Shift + Z", "undo, redo"},
    HelpLine{"Double click on a control", "reset it"},
    HelpLine{"Tab", "hide or show the panel"},
    HelpLine{nullptr, nullptr},
    HelpLine{"Ctrl + O, drop a file", "open a scene"},
    HelpLine{"R", "load the file again"},
    HelpLine{"P, F12", "save the picture as PNG"},
    HelpLine{"Ctrl + S", "save it as EXR, larger, or with the window"},
    HelpLine{"F1, ?", "this help"},
    HelpLine{"Esc, Ctrl + Q", "quit"},
};

}  // namespace

void help_overlay(UiState& state, const WindowRect& area) {
  if (!state.show_help) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({area.lo.x + 0.5f * area.size.x, area.lo.y + 0.5f * area.size.y},
                          ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.3f * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {1.6f * em, 1.2f * em});
  ImGui::Begin("help", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav);
  for (const HelpLine& line : help_lines) {
    if (!line.input) {
      ImGui::Dummy({0.0f, 0.4f * em});
      continue;
    }
    ImGui::TextUnformatted(line.input);
    ImGui::SameLine(18.0f * em);
    ImGui::TextDisabled("%s", line.meaning);
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void open_dialog(Controls& controls, UiState& state, Previewer& previewer) {
  constexpr const char* title = "Open a scene";
  if (state.show_open && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.4f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(46.0f * em, 0.9f * window.x), 0.0f});
  if (!ImGui::BeginPopupModal(title, nullptr,
                              ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_AlwaysAutoResize)) {
    return;
  }
  std::string chosen;
  ImGui::TextDisabled("Path of a .gltf or .glb file");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered =
      ImGui::InputText("##path", &state.open_path, ImGuiInputTextFlags_EnterReturnsTrue);
  controls.placed("Path", "Of a .gltf or .glb file, or builtin:NAME.");

  if (!state.recent.empty()) {
    ImGui::Spacing();
    ImGui::TextDisabled("or one that was open before");
  }
  for (std::size_t i = 0; i < state.recent.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(state.recent[i].c_str(), false, ImGuiSelectableFlags_DontClosePopups))
      chosen = state.recent[i];
    ImGui::PopID();
    controls.placed("Recent/" + std::to_string(i + 1), "Open this file.", Controls::Use::edits);
  }

  ImGui::Spacing();
  ImGui::TextDisabled("or a built-in scene");
  // What lies above and below stays within the window.
  const auto& builtins = builtin_scenes();
  constexpr float others = 9.0f, fewest = 5.0f;
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float room = window.y / line - others - static_cast<float>(state.recent.size());
  const float shown = std::clamp(room, fewest, static_cast<float>(builtins.size()));
  ImGui::BeginChild("built-in", {0.0f, shown * line});
  for (const BuiltinScene& scene : builtins) {
    if (ImGui::Selectable(scene.name.c_str(), false, ImGuiSelectableFlags_DontClosePopups)) {
      chosen = "builtin:" + scene.name;
    }
    controls.placed("Built-in/" + scene.name, scene.summary.c_str(), Controls::Use::edits);
    ImGui::SameLine(11.0f * em);
    ImGui::TextDisabled("%s", scene.summary.c_str());
  }
  ImGui::EndChild();

  ImGui::Spacing();
  if ((controls.button("Open", "Open the path that was typed. Key: Enter.", 6.0f * em) ||
       entered) &&
      !state.open_path.empty()) {
    chosen = state.open_path;
  }
  ImGui::SameLine();
  const bool cancelled = controls.button("Cancel", "Open nothing. Key: Esc.", 6.0f * em) ||
                         ImGui::IsKeyPressed(static_cast<int>(Key::escape), false);
  if (!chosen.empty()) previewer.scene().open(chosen);
  if (!chosen.empty() || cancelled) {
    state.show_open = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

namespace {

// Shows the stored frame in place of the picture, or no longer.
void flip(Frames& frames) {
  if (frames.stored.empty()) return;
  frames.flipped = !(frames.comparison == Comparison::flip && frames.flipped);
  frames.comparison = Comparison::flip;
}

}  // namespace

void handle_shortcuts(UiState& state, Previewer& previewer) {
  if (shortcut_pressed(Key::q, true)) state.quit = true;
  if (state.show_open || state.save.show) return;
  if (shortcut_pressed(Key::o, true)) state.show_open = true;
  if (shortcut_pressed(Key::s, true)) state.save.show = true;
  if (shortcut_pressed(Key::f1) || shortcut_pressed(Key::question)) {
    state.show_help = !state.show_help;
  }
  if (shortcut_pressed(Key::f12) || shortcut_pressed(Key::p)) state.screenshot_requested = true;
  if (shortcut_pressed(Key::home) || shortcut_pressed(Key::f)) previewer.viewpoint().frame_all();
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Right) && shortcut_pressed(Key::s) && previewer.scene())
    store_frame(state.frames, previewer);
  if (shortcut_pressed(Key::r)) previewer.scene().reload();
  if (shortcut_pressed(Key::x)) flip(state.frames);
  if (shortcut_pressed(Key::m)) state.display.show_split_map = !state.display.show_split_map;
  if (shortcut_pressed(Key::c)) {
    SplitMapColours& colours = state.display.split_colours;
    colours = colours == SplitMapColours::time
                  ? SplitMapColours::level
                  : static_cast<SplitMapColours>(static_cast<int>(colours) + 1);
  }
  if (shortcut_pressed(Key::space))
    previewer.refinement().set_paused(!previewer.refinement().paused());
  if (shortcut_pressed(Key::tab)) state.show_panel = !state.show_panel;
  if (shortcut_pressed(Key::one)) state.view.reset();
  const glm::vec2 middle = state.view.area_middle();
  if (shortcut_pressed(Key::plus)) state.view.zoom_at(middle, 1);
  if (shortcut_pressed(Key::minus)) state.view.zoom_at(middle, -1);

  // Escape closes what is open before it quits.
  if (!shortcut_pressed(Key::escape)) return;
  if (state.show_help) {
    state.show_help = false;
  } else if (previewer.scene().error()) {
    previewer.scene().dismiss_error();
  } else if (state.picked) {
    state.picked.reset();
  } else if (state.lights.selected >= 0) {
    state.lights.selected = -1;
  } else {
    state.quit = true;
  }
}

}  // namespace asos
