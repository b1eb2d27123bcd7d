#include "ui/panels/heat_strip.h"

#include "renderer/film/split_map.h"
#include "ui/theme.h"

#include <algorithm>

namespace asos::ui {

void heat_strip(std::span<const HeatTick> ticks) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.9f * em;
  constexpr int steps = 128;
  for (int i = 0; i < steps; ++i) {
    const float from = static_cast<float>(i) / steps, to = static_cast<float>(i + 1) / steps;
    const glm::u8vec3 c = heat_colour(0.5f * (from + to));
    draw->AddRectFilled({corner.x + from * width, corner.y},
                        {corner.x + to * width, corner.y + height}, IM_COL32(c.x, c.y, c.z, 255));
  }
  for (const HeatTick& tick : ticks) {
    const float x = corner.x + tick.share * width;
    const float text = ImGui::CalcTextSize(tick.text.c_str()).x;
    draw->AddText({std::clamp(x - 0.5f * text, corner.x, corner.x + width - text),
                   corner.y + height + 0.25f * em},
                  theme::packed(theme::dim_text), tick.text.c_str());
  }
  draw->AddRect(corner, {corner.x + width, corner.y + height}, theme::packed(theme::line));
  ImGui::Dummy({width, height + 1.4f * em});
}

}  // namespace asos::ui
