#include "ui/panels/controls.h"
#include "ui/panels/section_help.h"
#include "ui/panels/whole_words.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace asos::ui {

void Controls::row(const char* label_text, const std::string& value, const char* tooltip,
                   const RowStyle& how) {
  const float left = ImGui::GetCursorPosX(), top = ImGui::GetCursorPosY();
  ImGui::BeginGroup();
  name_text(label_text);
  // In a group, positions count from its left edge.
  const float widgets = ImGui::GetFontSize() * label_width_em;
  ImGui::SameLine(how.beside_widgets ? widgets - left : widgets + 3.0f * ImGui::GetFontSize());
  const auto width = [](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).x; };
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(in_whole_words(value, ImGui::GetContentRegionAvail().x, width).c_str());
  ImGui::PopTextWrapPos();
  // Lines of text are 20 units high, as everywhere in the panel.
  const float unit = ImGui::GetFontSize() / theme::text_pixels;
  const float between = unit * (theme::line_pixels - theme::text_pixels);
  if (how.lines > 1) {
    const float least = unit * theme::line_pixels * static_cast<float>(how.lines) - between;
    ImGui::SetCursorPosY(top + least);
    ImGui::Dummy({0.0f, 0.0f});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, between});
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  placed_words(label_text, value, tooltip);
}

namespace {

/// A word of other programs for a control or a section.
struct OtherWord {
  std::string_view word;
  std::string_view name;
};
constexpr std::array other_words{
    OtherWord{"bokeh", "Depth of field"},   OtherWord{"brightness", "Exposure"},
    OtherWord{"dof", "Depth of field"},     OtherWord{"envmap", "Sky"},
    OtherWord{"fov", "Field of view"},      OtherWord{"fps", "Frames/s"},
    OtherWord{"gamma", "Display"},          OtherWord{"hdri", "Sky"},
    OtherWord{"missed", "Compare"},         OtherWord{"noise", "Refinement"},
    OtherWord{"quality", "Antialiasing"},   OtherWord{"samples", "Antialiasing"},
    OtherWord{"threshold", "Antialiasing"}, OtherWord{"tolerance", "EPS"},
};
constexpr std::size_t least_letters = 3;  // of a search among these words

}  // namespace

bool Controls::section(const char* name, bool open_at_first) {
  section_ = name;
  if (!searched_.empty()) {
    // A section that was never open is drawn once, to find its controls' names.
    const std::set<std::string>& names = in_sections_[section_];
    const auto matches = [&](const std::string& control) { return found(control); };
    if (opened_.contains(section_) && !matches(section_) &&
        std::none_of(names.begin(), names.end(), matches))
      return false;
    found_any_ = true;
  }
  ImGui::Spacing();
  ImGui::Separator();
  const bool helps = has_section_help(name);
  const ImGuiTreeNodeFlags flags =
      helps ? ImGuiTreeNodeFlags_AllowItemOverlap : ImGuiTreeNodeFlags_None;
  const auto fold = folds_.find(name);
  const bool before = fold == folds_.end() ? open_at_first : fold->second;
  ImGui::SetNextItemOpen(!searched_.empty() || before);
  const bool open = ImGui::CollapsingHeader(name, flags);
  if (searched_.empty() && open != before) folds_[name] = open;
  if (open) opened_.insert(name);
  const std::string placed_name = std::string("section/") + name;
  placed(placed_name, nullptr);
  placed_[placed_name].words = open ? "open" : "folded";
  if (helps) help_button(name);
  return open;
}

bool Controls::found(const std::string& name) const {
  const auto same = [](char a, char b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return lower(a) == lower(b);
  };
  if (std::search(name.begin(), name.end(), searched_.begin(), searched_.end(), same) != name.end())
    return true;
  return std::any_of(other_words.begin(), other_words.end(), [&](const OtherWord& other) {
    const std::string_view word = other.word;
    return name == other.name && searched_.size() >= least_letters &&
           searched_.size() <= word.size() &&
           std::equal(searched_.begin(), searched_.end(), word.begin(), same);
  });
}

void Controls::note_in_section(const std::string& name) {
  if (!section_.empty()) in_sections_[section_].insert(name);
}

// The button is at the right end of the header.
void Controls::help_button(const char* section) {
  const float width = 1.6f * ImGui::GetFontSize();
  ImGui::PushID(section);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
  if (ImGui::Button("?", {width, 0.0f})) ImGui::OpenPopup("help");
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  placed(std::string("Help/") + section, "Explain this section.", Use::edits);
  if (ImGui::BeginPopup("help")) {
    section_help(section);
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

}  // namespace asos::ui
