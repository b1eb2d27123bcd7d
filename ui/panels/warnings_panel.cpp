#include "renderer/files/printable.h"
#include "renderer/scene/scene_warnings.h"
#include "ui/panels/inner_list.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr float most_rows = 6.0f;  // before the list scrolls

}  // namespace

void asset_root_button(Controls& controls, OpenScene& scene, float width) {
  if (scene.outer_root().empty()) return;
  const std::string text =
      fmt::format("Read files from {} too and reload.", printable(scene.outer_root()));
  if (controls.button("Allow folder", text.c_str(), width)) scene.widen_asset_root();
}

void warnings_panel(Controls& controls, const SceneNotes& notes, OpenScene& scene) {
  const std::vector<std::string> lines = scene_warnings(notes);
  if (lines.empty() || !controls.section("Warnings")) return;
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;

  const float spacing = ImGui::GetTextLineHeightWithSpacing();
  const float wrap = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
  float height = 0.0f;
  for (const std::string& line : lines) {
    height +=
        ImGui::CalcTextSize(line.c_str(), nullptr, false, wrap).y + ImGui::GetStyle().ItemSpacing.y;
  }
  {
    const InnerList list("warnings", {0.0f, std::min(height, most_rows * spacing)});
    ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::warning));
    ImGui::PushTextWrapPos(wrap);
    for (const std::string& line : lines) ImGui::TextUnformatted(line.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  controls.placed("Warnings", nullptr);
  if (controls.button("Copy warnings", "Copy the warnings to the clipboard.", -1.0f)) {
    ImGui::SetClipboardText(text.c_str());
  }
  asset_root_button(controls, scene, -1.0f);
}

}  // namespace asos::ui
