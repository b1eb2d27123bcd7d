#include "ui/panels/controls.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace asos::ui {

namespace {

float option_gap() {
  return ImGui::GetStyle().ItemInnerSpacing.x * 0.5f;
}

// Returns the width of a row of options minus their names and gaps.
float room_beside(std::span<const Controls::Option> options) {
  float taken = option_gap() * static_cast<float>(options.size() - 1);
  for (const Controls::Option& option : options) taken += ImGui::CalcTextSize(option.name).x;
  return ImGui::GetContentRegionAvail().x - taken;
}

// Minimum width around the names of `count` options.
float least_room(std::size_t count) {
  return 0.5f * ImGui::GetFontSize() * static_cast<float>(count);
}

// Options per row, for the smallest number of rows in which names do not touch.
std::size_t longest_row(std::span<const Controls::Option> options) {
  const std::size_t all = options.size();
  for (std::size_t rows = 1; rows < all; ++rows) {
    const std::size_t longest = (all + rows - 1) / rows;
    bool fits = true;
    for (std::size_t first = 0; first < all && fits; first += longest) {
      const auto row = options.subspan(first, std::min(longest, all - first));
      fits = room_beside(row) >= least_room(row.size());
    }
    if (fits) return longest;
  }
  return 1;
}

std::string first_sentence(std::string_view text) {
  const std::size_t end = text.find(". ");
  return std::string(end == std::string_view::npos ? text : text.substr(0, end + 1));
}

}  // namespace

float Controls::least_width(std::span<const Option> options) {
  return ImGui::GetContentRegionAvail().x - room_beside(options) + least_room(options.size());
}

bool Controls::options(const char* name, std::span<const Option> options, int& chosen,
                       const OptionsStyle& style) {
  const int before = chosen;
  if (style.labelled) label(name, options[static_cast<std::size_t>(std::max(0, chosen))].tooltip);
  const std::size_t longest = longest_row(options);
  const float left = ImGui::GetCursorPosX();
  for (std::size_t first = 0; first < options.size(); first += longest) {
    if (first > 0) ImGui::SetCursorPosX(left);
    const auto row = options.subspan(first, std::min(longest, options.size() - first));
    option_row(name, row, static_cast<int>(first), chosen);
  }
  reset(name, chosen, style.reset);
  return chosen != before;
}

// Each button gets the width of its name and an equal part of the rest.
void Controls::option_row(const char* name, std::span<const Option> options, int first,
                          int& chosen) {
  const float count = static_cast<float>(options.size());
  const float room = room_beside(options);
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const Option& option = options[static_cast<std::size_t>(i)];
    if (i > 0) ImGui::SameLine(0.0f, option_gap());
    const bool active = first + i == chosen;
    const ImVec4* colours = ImGui::GetStyle().Colors;
    ImGui::PushStyleColor(ImGuiCol_Button, colours[active ? ImGuiCol_SliderGrab : ImGuiCol_Button]);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                          colours[active ? ImGuiCol_SliderGrab : ImGuiCol_ButtonHovered]);
    ImGui::PushID(name);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    const float width = ImGui::CalcTextSize(option.name).x + room / count;
    if (ImGui::Button(option.name, {width, 0.0f})) chosen = first + i;
    ImGui::PopStyleVar();
    ImGui::PopID();
    ImGui::PopStyleColor(2);
    const std::string placed_name = std::string(name) + "/" + option.name;
    placed(placed_name, option.tooltip, Use::edits);
    if (active) placed_[placed_name].words = "chosen";
  }
}

bool Controls::list(const char* name, const char* tooltip, std::span<const std::string> items,
                    int& chosen, std::optional<int> to) {
  label(name, tooltip);
  const int before = chosen;
  const bool valid = chosen >= 0 && chosen < static_cast<int>(items.size());
  const char* preview = valid ? items[static_cast<std::size_t>(chosen)].c_str() : "";
  reset(name, chosen, to);
  // As high as the window allows: ImGui's default shows eight entries.
  if (!ImGui::BeginCombo(("##" + std::string(name)).c_str(), preview,
                         ImGuiComboFlags_HeightLargest)) {
    placed(name, tooltip, Use::edits);
    placed_[name].words = preview;
    return chosen != before;
  }
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    ImGui::PushID(i);
    if (ImGui::Selectable(items[static_cast<std::size_t>(i)].c_str(), i == chosen)) chosen = i;
    placed(std::string(name) + "/" + items[static_cast<std::size_t>(i)], tooltip);
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return chosen != before;
}

bool Controls::described_list(const char* name, std::span<const Option> options, int& chosen) {
  const int before = chosen;
  const bool valid = chosen >= 0 && chosen < static_cast<int>(options.size());
  const Option shown = valid ? options[static_cast<std::size_t>(chosen)] : Option{"", ""};
  label(name, shown.tooltip);
  const std::string own(name);
  if (!ImGui::BeginCombo(("##" + own).c_str(), shown.name, ImGuiComboFlags_HeightLargest)) {
    placed(own, shown.tooltip, Use::edits);
    placed_[own].words = shown.name;
    return false;
  }
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const Option& option = options[static_cast<std::size_t>(i)];
    if (ImGui::Selectable(option.name, i == chosen)) chosen = i;
    placed(own + "/" + option.name, option.tooltip);
    ImGui::SameLine(9.0f * ImGui::GetFontSize());
    const std::string line = first_sentence(option.tooltip);
    ImGui::TextDisabled("%s", line.c_str());
    placed_words(own + " line/" + option.name, line, nullptr);
  }
  ImGui::EndCombo();
  return chosen != before;
}

}  // namespace asos::ui
