#include "ui/panels/controls.h"

#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace asos {

namespace {

constexpr double tooltip_delay_seconds = 0.45;
constexpr float label_width_em = 6.4f;
constexpr float tooltip_width_em = 22.0f;

std::string hidden_label(const char* name) {
  return std::string("##") + name;
}

// Paints a bar with its text over the slider just drawn, whose own grab would hide the number.
// `from` and `to` are shares of its width. Leaves a slider alone that is being typed into.
void paint_slider(float from, float to, const std::string& text) {
  const bool active = ImGui::IsItemActive();
  if (active && ImGui::GetIO().WantTextInput) return;
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const float low = std::min(from, to), high = std::max(from, to);
  const auto x_at = [&](float share) {
    return std::round(lo.x + std::clamp(share, 0.0f, 1.0f) * (hi.x - lo.x));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const bool lit = active || ImGui::IsItemHovered();
  draw->AddRectFilled(lo, hi, theme::packed(lit ? theme::field_hovered : theme::field), rounding);
  draw->AddRectFilled({x_at(low), lo.y}, {x_at(high), hi.y}, theme::packed(theme::accent),
                      rounding);
  // A mark at the value, below the text, keeps an empty bar from looking like a text field.
  const float mark = std::round(0.2f * ImGui::GetFontSize());
  const float left = std::clamp(x_at(to) - 0.5f * mark, lo.x, hi.x - mark);
  draw->AddRectFilled({left, hi.y - 2.0f * mark}, {left + mark, hi.y},
                      theme::packed(theme::accent_bright));

  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  draw->PushClipRect(lo, hi, true);
  draw->AddText({std::round(0.5f * (lo.x + hi.x - size.x)), lo.y + 0.5f * (hi.y - lo.y - size.y)},
                theme::packed(theme::text), text.c_str());
  draw->PopClipRect();
}

// Beside the window that the item is in, so that no other control is hidden; at the pointer where
// there is no room.
void show_tooltip(const char* text) {
  const float em = ImGui::GetFontSize();
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const float left = ImGui::GetWindowPos().x - 0.4f * em;
  if (left > (tooltip_width_em + 2.0f) * em) {
    const bool upper = lo.y < 0.5f * ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({left, upper ? lo.y : hi.y}, ImGuiCond_Always,
                            {1.0f, upper ? 0.0f : 1.0f});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em * 0.7f, em * 0.5f});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(em * tooltip_width_em);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

float option_gap() {
  return ImGui::GetStyle().ItemInnerSpacing.x * 0.5f;
}

// What a row of options leaves of the width beside their names.
float room_beside(std::span<const Controls::Option> options) {
  float taken = option_gap() * static_cast<float>(options.size() - 1);
  for (const Controls::Option& option : options) taken += ImGui::CalcTextSize(option.name).x;
  return ImGui::GetContentRegionAvail().x - taken;
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
  show_tooltip(tooltip);
}

void Controls::label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(ImGui::GetFontSize() * label_width_em);
  ImGui::SetNextItemWidth(-1.0f);
}

bool Controls::slider(const char* name, const char* tooltip, float& value, float lo, float hi,
                      const std::function<std::string(float)>& words) {
  label(name);
  const bool changed = ImGui::SliderFloat(hidden_label(name).c_str(), &value, lo, hi, "%.2f",
                                          ImGuiSliderFlags_AlwaysClamp);
  const float zero = std::clamp(-lo / (hi - lo), 0.0f, 1.0f);
  paint_slider(zero, (value - lo) / (hi - lo), words(value));
  placed(name, tooltip);
  return changed;
}

bool Controls::slider(const char* name, const char* tooltip, int& value, int lo, int hi,
                      const std::function<std::string(int)>& words) {
  label(name);
  const bool changed = ImGui::SliderInt(hidden_label(name).c_str(), &value, lo, hi, "%d",
                                        ImGuiSliderFlags_AlwaysClamp);
  paint_slider(0.0f, static_cast<float>(value - lo) / static_cast<float>(hi - lo), words(value));
  placed(name, tooltip);
  return changed;
}

bool Controls::log_slider(const char* name, const char* tooltip, double& value, double hi,
                          const std::function<std::string(double)>& words) {
  label(name);
  // Dear ImGui begins its scale at the last decimal of the format.
  constexpr double least = 1e-4, lo = 0.0;
  const bool changed =
      ImGui::SliderScalar(hidden_label(name).c_str(), ImGuiDataType_Double, &value, &lo, &hi,
                          "%.4f", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  const double share = value > least ? std::log(value / least) / std::log(hi / least) : 0.0;
  paint_slider(0.0f, static_cast<float>(share), words(value));
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

bool Controls::options(const char* name, std::span<const Option> options, int& chosen,
                       bool labelled) {
  if (labelled) label(name);
  // In two rows where their names would touch.
  const float touching = 0.5f * ImGui::GetFontSize() * static_cast<float>(options.size());
  if (room_beside(options) >= touching) return option_row(name, options, 0, chosen);
  const std::size_t half = (options.size() + 1) / 2;
  const bool upper = option_row(name, options.first(half), 0, chosen);
  return option_row(name, options.subspan(half), static_cast<int>(half), chosen) || upper;
}

// The buttons share the width by the lengths of their names.
bool Controls::option_row(const char* name, std::span<const Option> options, int first,
                          int& chosen) {
  const float count = static_cast<float>(options.size());
  const float room = room_beside(options);
  bool changed = false;
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
    if (ImGui::Button(option.name, {width, 0.0f}) && !active) {
      chosen = first + i;
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
