#include "ui/panels/controls.h"

#include "renderer/film/film.h"
#include "renderer/shading/texture.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asos::ui {

namespace {

constexpr double tooltip_delay_seconds = 0.45;
constexpr float tooltip_width_em = 22.0f;

std::string hidden_label(const char* name) {
  return std::string("##") + name;
}

// Whether a value is being typed into the item.
bool types() {
  return ImGui::IsItemActive() && ImGui::GetIO().WantTextInput;
}

// Paints the item's field without its contents.
void paint_field(ImVec2 lo, ImVec2 hi) {
  const bool lit = ImGui::IsItemActive() || ImGui::IsItemHovered();
  ImGui::GetWindowDrawList()->AddRectFilled(
      lo, hi, theme::packed(lit ? theme::field_hovered : theme::field),
      ImGui::GetStyle().FrameRounding);
}

// Paints centred text from the height `top` on, within the field.
void paint_words(ImVec2 lo, ImVec2 hi, float top, const std::string& text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(lo, hi, true);
  draw->AddText({std::round(0.5f * (lo.x + hi.x - ImGui::CalcTextSize(text.c_str()).x)), top},
                theme::packed(theme::text), text.c_str());
  draw->PopClipRect();
}

// Paints a bar below text over the slider that was just drawn, whose grab would hide the number.
// `from` and `to` are fractions of its width. Does nothing while a value is typed.
void paint_slider(float from, float to, const std::string& text) {
  if (types()) return;
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const float low = std::min(from, to), high = std::max(from, to);
  const auto x_at = [&](float share) {
    return std::round(lo.x + std::clamp(share, 0.0f, 1.0f) * (hi.x - lo.x));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  paint_field(lo, hi);
  // The bar lies below the text, which stays legible at any value.
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float thick = std::max(3.0f, std::round(0.28f * em));
  draw->AddRectFilled({x_at(low), hi.y - thick}, {x_at(high), hi.y}, theme::packed(theme::accent));
  // A mark at the value distinguishes an empty bar from a text field.
  const float mark = std::round(0.3f * em);
  const float left = std::clamp(x_at(to) - 0.5f * mark, lo.x, hi.x - mark);
  draw->AddRectFilled({left, hi.y - thick - std::round(0.1f * em)}, {left + mark, hi.y},
                      theme::packed(theme::accent_bright));

  paint_words(lo, hi, std::round(lo.y + 0.5f * (hi.y - thick - lo.y - line)), text);
}

// Paints text over the number that was just drawn, instead of Dear ImGui's own.
void paint_number(const std::string& text) {
  if (types()) return;
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  paint_field(lo, hi);
  paint_words(lo, hi, lo.y + 0.5f * (hi.y - lo.y - ImGui::GetTextLineHeight()), text);
}

// Places the tooltip above the bar, if the item is in it, or to the left of the item's window, so
// that it hides no control; at the pointer if there is no room.
void show_tooltip(const char* text, std::optional<float> bar_top) {
  const float em = ImGui::GetFontSize();
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const float left = ImGui::GetWindowPos().x - 0.4f * em;
  if (bar_top) {
    ImGui::SetNextWindowPos({lo.x, *bar_top - 0.3f * em}, ImGuiCond_Always, {0.0f, 1.0f});
  } else if (left > (tooltip_width_em + 2.0f) * em) {
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

}  // namespace

std::string number_words(double value) {
  const double size = std::abs(value);
  constexpr double digits = 1e4, most = 1e7;
  return size >= digits && size < most ? fmt::format("{:.0f}", value)
                                       : fmt::format("{:.4g}", value);
}

std::string degree_words(float angle_deg) {
  // Adding 0 makes a rounded -0 positive.
  return fmt::format("{:.1f}\u00b0", std::round(10.0f * angle_deg) / 10.0f + 0.0f);
}

std::string percent_words(float fraction) {
  return fmt::format("{:.0f} %", 100.0f * fraction);
}

void Controls::begin_frame(double now_seconds) {
  placed_.clear();
  section_.clear();
  // The last frame's hovered item starts the tooltip's delay.
  if (hovered_ != hovered_before_) hovered_since_seconds_ = now_seconds_;
  now_seconds_ = now_seconds;
  hovered_before_ = hovered_;
  tooltip_before_ = std::exchange(tooltip_now_, false);
  hovered_.clear();
  told_ = {};
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) resetting_.clear();
}

double Controls::tooltip_wait(const std::string& name) const {
  const double since = name == hovered_before_ ? hovered_since_seconds_ : now_seconds_;
  return since + tooltip_delay_seconds - now_seconds_;
}

std::optional<double> Controls::seconds_to_tooltip() const {
  if (hovered_.empty()) return std::nullopt;
  const double left = tooltip_wait(hovered_);
  return left > 0.0 ? std::optional(left) : std::nullopt;
}

void Controls::placed(const std::string& name, const char* tooltip, Use use) {
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const ImVec2 window = ImGui::GetWindowPos();
  placed_[name] = {{lo.x, lo.y},      {hi.x, hi.y},         tooltip != nullptr,
                   use == Use::edits, {window.x, window.y}, {}};
  note_in_section(name);
  explain(name, tooltip);
}

void Controls::placed_words(const std::string& name, const std::string& words,
                            const char* tooltip) {
  placed(name, tooltip);
  placed_[name].words = words;
}

void Controls::text(const std::string& name, const std::string& words, const char* tooltip) {
  ImGui::TextUnformatted(words.c_str());
  placed_words(name, words, tooltip);
}

void Controls::dim_text(const std::string& name, const std::string& words, const char* tooltip) {
  ImGui::TextDisabled("%s", words.c_str());
  placed_words(name, words, tooltip);
}

void Controls::warning(const char* name, const std::string& words, theme::Colour colour) {
  if (words.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(colour));
  ImGui::TextWrapped("%s", words.c_str());
  ImGui::PopStyleColor();
  placed_words(name, words, nullptr);
}

bool Controls::text_field(const char* name, const char* tooltip, const char* hint,
                          std::string& text) {
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputTextWithHint(hidden_label(name).c_str(), hint, &text,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  placed(name, tooltip, Use::edits);
  return entered;
}

void Controls::placed_window(const std::string& name) {
  const ImVec2 lo = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  placed_[name] = {{lo.x, lo.y}, {lo.x + size.x, lo.y + size.y}, false, false, {lo.x, lo.y}, {}};
}

void Controls::explain(const std::string& name, const char* tooltip) {
  if (!tooltip || ImGui::IsItemActive() || !ImGui::IsItemHovered()) return;
  hovered_ = name;
  if (tooltip_wait(name) <= 0.0) tell(name, tooltip);
}

void Controls::tell(const std::string& name, const char* text) {
  const auto bar = placed_.find("Picture bar");
  const ImVec2 lo = ImGui::GetItemRectMin();
  const bool in_bar = bar != placed_.end() && lo.y >= bar->second.lo.y && lo.x < bar->second.hi.x;
  show_tooltip(text, in_bar ? std::optional(bar->second.lo.y) : std::nullopt);
  told_ = {name, text};
  tooltip_now_ = true;
}

void Controls::name_text(const char* name) {
  if (searched_.empty() || !found(name)) return ImGui::TextDisabled("%s", name);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::accent_bright));
  ImGui::TextUnformatted(name);
  ImGui::PopStyleColor();
}

// The name has the widget's tooltip, and a double click on it resets the widget.
void Controls::label(const char* name, const char* tooltip) {
  ImGui::SetNextItemWidth(-1.0f);
  if (!labelled_) return;
  ImGui::AlignTextToFramePadding();
  name_text(name);
  note_double_click(name);
  explain(name, tooltip);
  // Long labels move their widget to the right.
  const float left = ImGui::GetStyle().WindowPadding.x;
  const float text = ImGui::CalcTextSize(name).x + 0.6f * ImGui::GetFontSize();
  ImGui::SameLine(std::max(ImGui::GetFontSize() * label_width_em, left + text));
  ImGui::SetNextItemWidth(-1.0f);
}

void Controls::note_double_click(const char* name) {
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    resetting_ = name;
}

// An active widget takes the pointer's value in every frame, so the reset is repeated until the
// button is released.
template <typename T>
bool Controls::reset(const char* name, T& value, const std::optional<T>& to) {
  if (!to || resetting_ != name || value == *to) return false;
  value = *to;
  return true;
}
template bool Controls::reset<int>(const char* name, int& value, const std::optional<int>& to);

// `draw` draws Dear ImGui's widget with this identifier, and `paint` the value over it.
template <typename T, typename Draw, typename Paint>
bool Controls::edited(const char* name, const char* tooltip, T& value, const std::optional<T>& to,
                      const Draw& draw, const Paint& paint) {
  label(name, tooltip);
  const T before = value;
  draw(hidden_label(name).c_str());
  note_double_click(name);
  reset(name, value, to);
  paint();
  placed(name, tooltip, Use::edits);
  return value != before;
}

bool Controls::slider(const char* name, const char* tooltip, float& value,
                      const Range<float>& range, const std::function<std::string(float)>& words) {
  const float width = range.hi - range.lo, zero = std::clamp(-range.lo / width, 0.0f, 1.0f);
  return edited(
      name, tooltip, value, range.reset,
      [&](const char* id) {
        ImGui::SliderFloat(id, &value, range.lo, range.hi, "%.2f", ImGuiSliderFlags_AlwaysClamp);
      },
      [&] { paint_slider(zero, (value - range.lo) / width, words(value)); });
}

bool Controls::slider(const char* name, const char* tooltip, int& value, const Range<int>& range,
                      const std::function<std::string(int)>& words) {
  const auto width = static_cast<float>(range.hi - range.lo);
  return edited(
      name, tooltip, value, range.reset,
      [&](const char* id) {
        ImGui::SliderInt(id, &value, range.lo, range.hi, "%d", ImGuiSliderFlags_AlwaysClamp);
      },
      [&] { paint_slider(0.0f, static_cast<float>(value - range.lo) / width, words(value)); });
}

bool Controls::slider(const char* name, const char* tooltip, double& value,
                      const Range<double>& range, const std::function<std::string(float)>& words) {
  auto shown = static_cast<float>(value);
  Range<float> narrow{static_cast<float>(range.lo), static_cast<float>(range.hi), std::nullopt};
  if (range.reset) narrow.reset = static_cast<float>(*range.reset);
  if (!slider(name, tooltip, shown, narrow, words)) return false;
  value = static_cast<double>(shown);
  return true;
}

bool Controls::angle_slider(const char* name, const char* tooltip, double& angle_rad,
                            const Range<double>& range_deg,
                            const std::function<std::string(float)>& words) {
  double angle_deg = glm::degrees(angle_rad);
  if (!slider(name, tooltip, angle_deg, range_deg, words)) return false;
  angle_rad = glm::radians(angle_deg);
  return true;
}

bool Controls::log_slider(const char* name, const char* tooltip, double& value,
                          const Range<double>& range,
                          const std::function<std::string(double)>& words) {
  constexpr ImGuiSliderFlags flags = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;
  return edited(
      name, tooltip, value, range.reset,
      [&](const char* id) {
        ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &range.lo, &range.hi, "%.4f", flags);
      },
      [&] { paint_slider(0.0f, log_share(value, range.hi), words(value)); });
}

float Controls::log_share(double value, double most) {
  // Dear ImGui starts the logarithmic scale at the last decimal of the format.
  constexpr double least = 1e-4;
  return value > least ? static_cast<float>(std::log(value / least) / std::log(most / least))
                       : 0.0f;
}

// Hides double clicks from Dear ImGui, which would start typing.
bool Controls::drag(const std::string& id, double& value, const Drag& drag) {
  ImGuiIO& io = ImGui::GetIO();
  const ImU16 clicks =
      std::exchange(io.MouseClickedCount[0], std::min(io.MouseClickedCount[0], ImU16{1}));
  const double step = drag.is_size ? std::max(drag.step, 0.01 * std::abs(value)) : drag.step;
  const bool changed = ImGui::DragScalar(
      id.c_str(), ImGuiDataType_Double, &value, static_cast<float>(step), &drag.range.lo,
      &drag.range.hi, "%.6g", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
  io.MouseClickedCount[0] = clicks;
  return changed;
}

bool Controls::number(const char* name, const char* tooltip, double& value, const Drag& how,
                      const std::function<std::string(double)>& words) {
  return edited(
      name, tooltip, value, how.range.reset, [&](const char* id) { drag(id, value, how); },
      [&] { paint_number(words(value)); });
}

bool Controls::vector(const char* name, const char* tooltip, glm::dvec3& value, double step,
                      const glm::dvec3& to) {
  label(name, tooltip);
  const float gap = 0.5f * ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  const glm::dvec3 before = value;
  constexpr double limit = 1e9;
  for (int k = 0; k < 3; ++k) {
    constexpr std::array axes{"x", "y", "z"};
    if (k > 0) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    const std::string id = std::string(name) + "/" + axes[static_cast<std::size_t>(k)];
    drag("##" + id, value[k], {{-limit, limit, std::nullopt}, step, false});
    paint_number(number_words(value[k]));
    placed(id, tooltip, Use::edits);
  }
  reset(name, value, std::optional(to));
  return value != before;
}

bool Controls::colour(const char* name, const char* tooltip, glm::vec3& linear,
                      const glm::vec3& to) {
  label(name, tooltip);
  const glm::u8vec3 bytes = display_bytes(linear, 0.0f);
  std::array<float, 3> shown{};
  for (int k = 0; k < 3; ++k)
    shown[static_cast<std::size_t>(k)] = static_cast<float>(bytes[k]) / 255.0f;
  const bool changed = ImGui::ColorEdit3(
      hidden_label(name).c_str(), shown.data(),
      ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_Uint8 | ImGuiColorEditFlags_NoOptions);
  note_double_click(name);
  placed(name, tooltip, Use::edits);
  if (reset(name, linear, std::optional(to))) return true;
  if (!changed || resetting_ == name) return false;
  for (int k = 0; k < 3; ++k) {
    const float byte =
        std::round(255.0f * std::clamp(shown[static_cast<std::size_t>(k)], 0.0f, 1.0f));
    linear[k] = srgb_byte_to_linear(static_cast<std::uint8_t>(byte));
  }
  return true;
}

bool Controls::checkbox(const char* name, const char* tooltip, bool& value,
                        std::optional<bool> to) {
  label(name, tooltip);
  const bool before = value;
  ImGui::Checkbox(hidden_label(name).c_str(), &value);
  reset(name, value, to);
  placed(name, tooltip, Use::edits);
  return value != before;
}

bool Controls::button(const char* name, const char* tooltip, float width) {
  const bool pressed = ImGui::Button(name, {width, 0.0f});
  placed(name, tooltip, Use::edits);
  return pressed;
}

float Controls::button_width(int count) {
  const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
  return (ImGui::GetContentRegionAvail().x - gaps) / static_cast<float>(count);
}

int Controls::buttons(std::initializer_list<Option> buttons) {
  const float width = button_width(static_cast<int>(buttons.size()));
  int pressed = -1, index = 0;
  for (const Option& option : buttons) {
    if (index > 0) ImGui::SameLine();
    if (button(option.name, option.tooltip, width)) pressed = index;
    ++index;
  }
  return pressed;
}

Controls::Handle Controls::handle(const char* name, const char* tooltip, glm::vec2 at) {
  const float r = 0.6f * ImGui::GetFontSize();
  ImGui::SetCursorScreenPos({at.x - r, at.y - r});
  ImGui::InvisibleButton(hidden_label(name).c_str(), {2.0f * r, 2.0f * r});
  note_double_click(name);
  placed(name, tooltip, Use::edits);
  Handle handle;
  handle.lit = ImGui::IsItemActive() || ImGui::IsItemHovered();
  handle.reset = resetting_ == name;
  const ImGuiIO& io = ImGui::GetIO();
  const bool dragged = io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f;
  if (ImGui::IsItemActive() && dragged && !handle.reset)
    handle.moved = glm::vec2(io.MousePos.x, io.MousePos.y);
  return handle;
}

}  // namespace asos::ui
