#include "ui/panels/scale_strip.h"

#include "renderer/film/split_map.h"
#include "ui/theme.h"

#include <imgui.h>

#include <algorithm>

namespace asos::ui {

void scale_strip(Controls& controls, const char* name, const char* tooltip,
                 std::span<const ScaleTick> ticks,
                 const std::function<glm::u8vec3(float)>& colour) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.9f * em;
  constexpr int steps = 128;
  for (int i = 0; i < steps; ++i) {
    const float from = static_cast<float>(i) / steps, to = static_cast<float>(i + 1) / steps;
    const float middle = 0.5f * (from + to);
    draw->AddRectFilled({corner.x + from * width, corner.y},
                        {corner.x + to * width, corner.y + height},
                        theme::packed(colour ? colour(middle) : heat_colour(middle)));
  }
  std::string words;
  for (const ScaleTick& tick : ticks) {
    words += (words.empty() ? "" : " ") + tick.text;
    const float x = corner.x + tick.share * width;
    draw->AddLine({x, corner.y + height}, {x, corner.y + height + 0.2f * em},
                  theme::packed(theme::dim_text));
    const float text = ImGui::CalcTextSize(tick.text.c_str()).x;
    draw->AddText({std::clamp(x - 0.5f * text, corner.x, corner.x + width - text),
                   corner.y + height + 0.25f * em},
                  theme::packed(theme::dim_text), tick.text.c_str());
  }
  draw->AddRect(corner, {corner.x + width, corner.y + height}, theme::packed(theme::line));
  ImGui::Dummy({width, height + 1.4f * em});
  controls.placed_words(name, words, tooltip);
}

}  // namespace asos::ui
