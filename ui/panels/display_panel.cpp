#include "renderer/film/film.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <string>

namespace asos {

namespace {

// The split map's colours on their absolute scale: a level keeps its colour whatever the picture
// holds.
void split_legend(Controls& controls, int max_level) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.9f * em;
  const float step = width / static_cast<float>(max_level + 1);
  for (int level = 0; level <= max_level; ++level) {
    const glm::u8vec3 c = split_colour(level, max_level);
    const float left = corner.x + step * static_cast<float>(level);
    draw->AddRectFilled({left, corner.y}, {left + step, corner.y + height},
                        IM_COL32(c.x, c.y, c.z, 255));
    const std::string number = level == 0 ? std::string("not split") : std::to_string(level);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    const float middle = left + 0.5f * (step - size.x);
    draw->AddText({level == 0 ? std::max(left, middle) : middle, corner.y + height + 0.15f * em},
                  theme::packed(theme::dim_text),
                  level == 0 && size.x > step ? "0" : number.c_str());
  }
  draw->AddRect(corner, {corner.x + width, corner.y + height}, theme::packed(theme::line));
  ImGui::Dummy({width, height + 1.3f * em});
  controls.placed("Legend",
                  "The deepest level that a pixel was split to, from 0 to MAX. A level keeps its "
                  "colour whatever the picture shows.");
}

}  // namespace

void display_panel(Controls& controls, DisplaySettings& display, int max_level) {
  if (!controls.section("Display")) return;
  controls.slider("Exposure",
                  "Brightness of the picture in stops: +1 doubles it. Changes what is shown, not "
                  "what is rendered.",
                  display.exposure_ev, -DisplaySettings::exposure_limit_ev,
                  DisplaySettings::exposure_limit_ev,
                  [](float ev) { return fmt::format("{:+.2f} EV", ev); });
  controls.checkbox("Split map",
                    "Colour each split pixel by the deepest level that it was split to. Key: M.",
                    display.show_split_map);
  if (!display.show_split_map) return;
  controls.slider("Dimming",
                  "How dark the pixels that are not split become under the split map, 0 to 100 %.",
                  display.split_dimming, 0.0f, 1.0f,
                  [](float share) { return fmt::format("{:.0f} %", 100.0f * share); });
  split_legend(controls, max_level);
}

}  // namespace asos
