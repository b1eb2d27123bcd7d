#include "ui/panels/controls.h"

#include <imgui.h>

#include <algorithm>

namespace asos {

namespace {

constexpr double tooltip_delay_seconds = 0.45;
constexpr float label_width_em = 6.4f;

std::string hidden_label(const char* name) {
  return std::string("##") + name;
}

}  // namespace

void Controls::begin_frame(double now_seconds) {
  now_seconds_ = now_seconds;
  placed_.clear();
  if (hovered_ != hovered_before_) hovered_since_seconds_ = now_seconds;
  hovered_before_ = hovered_;
  hovered_.clear();
}

std::optional<double> Controls::seconds_to_tooltip() const {
  if (hovered_.empty()) return std::nullopt;
  const double since = hovered_ == hovered_before_ ? hovered_since_seconds_ : now_seconds_;
  const double left = since + tooltip_delay_seconds - now_seconds_;
  return left > 0.0 ? std::optional(left) : std::nullopt;
}

void Controls::placed(const std::string& name, const char* tooltip) {
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  placed_[name] = {{lo.x, lo.y}, {hi.x, hi.y}, tooltip != nullptr};
  if (!tooltip || ImGui::IsItemActive() || !ImGui::IsItemHovered()) return;
  hovered_ = name;
  if (name != hovered_before_ || now_seconds_ - hovered_since_seconds_ < tooltip_delay_seconds) {
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {ImGui::GetFontSize() * 0.7f, ImGui::GetFontSize() * 0.5f});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22.0f);
  ImGui::TextUnformatted(tooltip);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void Controls::label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(ImGui::GetFontSize() * label_width_em);
  ImGui::SetNextItemWidth(-1.0f);
}

bool Controls::slider(const char* name, const char* tooltip, float& value, float lo, float hi,
                      const char* format) {
  label(name);
  const bool changed = ImGui::SliderFloat(hidden_label(name).c_str(), &value, lo, hi, format,
                                          ImGuiSliderFlags_AlwaysClamp);
  placed(name, tooltip);
  return changed;
}

bool Controls::slider(const char* name, const char* tooltip, int& value, int lo, int hi,
                      const char* format) {
  label(name);
  const bool changed = ImGui::SliderInt(hidden_label(name).c_str(), &value, lo, hi, format,
                                        ImGuiSliderFlags_AlwaysClamp);
  placed(name, tooltip);
  return changed;
}

bool Controls::log_slider(const char* name, const char* tooltip, double& value, double lo,
                          double hi, const char* format) {
  label(name);
  const bool changed =
      ImGui::SliderScalar(hidden_label(name).c_str(), ImGuiDataType_Double, &value, &lo, &hi,
                          format, ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  placed(name, tooltip);
  return changed;
}

bool Controls::checkbox(const char* name, const char* tooltip, bool& value) {
  label(name);
  const bool changed = ImGui::Checkbox(hidden_label(name).c_str(), &value);
  placed(name, tooltip);
  return changed;
}

bool Controls::button(const char* name, const char* tooltip, float width) {
  const bool pressed = ImGui::Button(name, {width, 0.0f});
  placed(name, tooltip);
  return pressed;
}

bool Controls::options(const char* name, std::span<const Option> options, int& chosen) {
  label(name);
  // The buttons share the width by the lengths of their names.
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x * 0.5f;
  float text_width = 0.0f;
  for (const Option& option : options) text_width += ImGui::CalcTextSize(option.name).x;
  const float count = static_cast<float>(options.size());
  const float room = ImGui::GetContentRegionAvail().x - gap * (count - 1.0f) - text_width;
  bool changed = false;
  for (int i = 0; i < static_cast<int>(options.size()); ++i) {
    const Option& option = options[static_cast<std::size_t>(i)];
    if (i > 0) ImGui::SameLine(0.0f, gap);
    const bool active = i == chosen;
    const ImVec4* colours = ImGui::GetStyle().Colors;
    ImGui::PushStyleColor(ImGuiCol_Button, colours[active ? ImGuiCol_SliderGrab : ImGuiCol_Button]);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                          colours[active ? ImGuiCol_SliderGrab : ImGuiCol_ButtonHovered]);
    ImGui::PushID(name);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    const float width = ImGui::CalcTextSize(option.name).x + room / count;
    if (ImGui::Button(option.name, {width, 0.0f}) && !active) {
      chosen = i;
      changed = true;
    }
    ImGui::PopStyleVar();
    ImGui::PopID();
    ImGui::PopStyleColor(2);
    placed(std::string(name) + "/" + option.name, option.tooltip);
  }
  return changed;
}

bool Controls::list(const char* name, const char* tooltip, std::span<const std::string> items,
                    int& chosen) {
  label(name);
  const bool valid = chosen >= 0 && chosen < static_cast<int>(items.size());
  const char* preview = valid ? items[static_cast<std::size_t>(chosen)].c_str() : "";
  bool changed = false;
  const bool open = ImGui::BeginCombo(hidden_label(name).c_str(), preview);
  if (!open) placed(name, tooltip);
  if (!open) return false;
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    ImGui::PushID(i);
    if (ImGui::Selectable(items[static_cast<std::size_t>(i)].c_str(), i == chosen)) {
      chosen = i;
      changed = true;
    }
    placed(std::string(name) + "/" + items[static_cast<std::size_t>(i)], nullptr);
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return changed;
}

void Controls::row(const char* label_text, const std::string& value, const char* tooltip) {
  ImGui::BeginGroup();
  ImGui::TextDisabled("%s", label_text);
  ImGui::SameLine(ImGui::GetFontSize() * (label_width_em + 3.0f));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
  placed(label_text, tooltip);
}

bool Controls::section(const char* name, bool open_at_first) {
  ImGui::Spacing();
  ImGui::Separator();
  const bool open = ImGui::CollapsingHeader(
      name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  placed(std::string("section/") + name, nullptr);
  return open;
}

}  // namespace asos
