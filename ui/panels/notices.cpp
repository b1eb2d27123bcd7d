#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
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

}  // namespace

void notices(Controls& controls, OpenScene& scene, const WindowRect& area) {
  if (area.size.x < 1.0f || area.size.y < 1.0f) return;
  const std::optional<SceneLoader::Loading> loading = scene.loading();
  if (loading) {
    begin_notice("loading", area, 20.0f, 0.5f);
    ImGui::TextUnformatted(("Loading " + short_name(loading->source)).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", fmt::format("{:.1f} s", loading->seconds).c_str());
    // The duration of loading is unknown, so the bar only runs in a loop.
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, em = ImGui::GetFontSize();
    const double lap = loading->seconds * 0.7;
    const float left = static_cast<float>(lap - std::floor(lap)) * 1.3f - 0.3f;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(corner, {corner.x + width, corner.y + 0.2f * em},
                        theme::packed(theme::field));
    draw->AddRectFilled({corner.x + width * std::max(left, 0.0f), corner.y},
                        {corner.x + width * std::min(left + 0.3f, 1.0f), corner.y + 0.2f * em},
                        theme::packed(theme::accent_bright));
    ImGui::Dummy({width, 0.2f * em});
    end_notice();
  } else if (!scene && !scene.error()) {
    begin_notice("empty", area, 24.0f, 0.5f);
    ImGui::TextUnformatted("Drop a .gltf or .glb file here");
    ImGui::TextDisabled("or press Ctrl+O");
    end_notice();
  }
  if (scene.error()) error_notice(controls, scene, area);
}

}  // namespace asos::ui
