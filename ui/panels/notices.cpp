#include "renderer/files/printable.h"
#include "ui/panels/overlay_window.h"
#include "ui/panels/overlays.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cstddef>

namespace asos::ui {

namespace {

void error_notice(Controls& controls, OpenScene& scene, const WindowRect& area) {
  const Error error = *scene.error();
  place_notice(area, 36.0f, 0.04f, 0.04f);
  const OverlayWindow window("error");
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::alarm));
  // Errors of a method that cannot render the open scene also appear here.
  const bool open = scene && scene->geometry->source == scene.asked_for();
  const char* headline = open ? "Not possible with this scene" : "Could not open";
  if (scene.reload_failed()) headline = "Reload failed; still showing the last good version";
  ImGui::TextUnformatted(headline);
  ImGui::PopStyleColor();
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(printable(error.subject).c_str());
  ImGui::TextDisabled("%s", printable(error.reason).c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  if (controls.button("Copy", "Copy the message.")) {
    ImGui::SetClipboardText(error.message().c_str());
  }
  ImGui::SameLine();
  if (!scene.outer_root().empty()) {
    asset_root_button(controls, scene, 0.0f);
    ImGui::SameLine();
  }
  if (controls.button("Close", "Close (Esc).")) scene.dismiss_error();
}

const char* stage_words(LoadStage stage) {
  constexpr std::array words{"Reading file",     "Decoding textures", "Reading meshes",
                             "Placing objects",  "Finding lights",    "Building ray hierarchy",
                             "Preparing picture"};
  static_assert(words.size() == load_stage_count);
  return words[static_cast<std::size_t>(stage)];
}

/// Draws one field for each stage, filled up to the current one.
void stage_fields(LoadStage stage) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, em = ImGui::GetFontSize();
  const float step = width / static_cast<float>(load_stage_count), gap = 0.15f * em;
  for (std::size_t i = 0; i < load_stage_count; ++i) {
    const float left = corner.x + step * static_cast<float>(i);
    const bool reached = i <= static_cast<std::size_t>(stage);
    ImGui::GetWindowDrawList()->AddRectFilled(
        {left, corner.y}, {left + step - gap, corner.y + 0.2f * em},
        theme::packed(reached ? theme::accent_bright : theme::field));
  }
  ImGui::Dummy({width, 0.2f * em});
}

void loading_notice(const SceneLoader::Loading& loading, const WindowRect& area) {
  place_notice(area, 22.0f, 0.9f, 0.9f);
  const OverlayWindow window("loading");
  ImGui::TextUnformatted(("Loading " + printable(file_title(loading.source))).c_str());
  ImGui::TextDisabled(
      "%s", fmt::format("{}   {:.1f} s", stage_words(loading.stage), loading.seconds).c_str());
  stage_fields(loading.stage);
}

}  // namespace

void notices(Controls& controls, OpenScene& scene, const WindowRect& area) {
  if (area.size.x < 1.0f || area.size.y < 1.0f) return;
  const std::optional<SceneLoader::Loading> loading = scene.loading();
  // The status line has the progress of textures that follow.
  if (loading && scene.textures_missing() == 0) {
    loading_notice(*loading, area);
  } else if (!scene && !scene.error()) {
    place_notice(area, 24.0f, 0.5f, 0.5f);
    const OverlayWindow window("empty");
    ImGui::TextUnformatted("Drop a .gltf or .glb file here");
    ImGui::TextDisabled("or press Ctrl+O");
  }
  if (scene.error()) error_notice(controls, scene, area);
}

}  // namespace asos::ui
