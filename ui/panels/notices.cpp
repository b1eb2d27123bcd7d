#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>

namespace asos::ui {

namespace {

constexpr ImGuiWindowFlags notice_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_NoFocusOnAppearing;

std::string short_name(const std::string& source) {
  if (source.starts_with("builtin:")) return source.substr(8);
  return printable(std::filesystem::path(source).filename().string());
}

void begin_notice(const char* name, const WindowRect& area, float width_em, float height_share) {
  const float em = ImGui::GetFontSize();
  const float width = std::min(width_em * em, area.size.x - 2.0f * em);
  ImGui::SetNextWindowPos({area.lo.x + 0.5f * area.size.x, area.lo.y + height_share * area.size.y},
                          ImGuiCond_Always, {0.5f, height_share});
  ImGui::SetNextWindowSize({std::max(width, em), 0.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.3f * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::Begin(name, nullptr, notice_flags);
}

void end_notice() {
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void error_notice(Controls& controls, OpenScene& scene, const WindowRect& area) {
  const Error error = *scene.error();
  begin_notice("error", area, 36.0f, 0.04f);
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
  end_notice();
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
  begin_notice("loading", area, 22.0f, 0.9f);
  ImGui::TextUnformatted(("Loading " + short_name(loading.source)).c_str());
  ImGui::TextDisabled(
      "%s", fmt::format("{}   {:.1f} s", stage_words(loading.stage), loading.seconds).c_str());
  stage_fields(loading.stage);
  end_notice();
}

}  // namespace

void notices(Controls& controls, OpenScene& scene, const WindowRect& area) {
  if (area.size.x < 1.0f || area.size.y < 1.0f) return;
  const std::optional<SceneLoader::Loading> loading = scene.loading();
  // The status line has the progress of textures that follow.
  if (loading && scene.textures_missing() == 0) {
    loading_notice(*loading, area);
  } else if (!scene && !scene.error()) {
    begin_notice("empty", area, 24.0f, 0.5f);
    ImGui::TextUnformatted("Drop a .gltf or .glb file here");
    ImGui::TextDisabled("or press Ctrl+O");
    end_notice();
  }
  if (scene.error()) error_notice(controls, scene, area);
}

}  // namespace asos::ui
