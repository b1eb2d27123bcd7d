#include "ui/legend_strip.h"
#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/scale_strip.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

constexpr float legend_width_em = 24.0f;

constexpr std::array<const char*, split_cause_count> cause_words{
    "One sample, or one cell, was enough.",
    "Silhouette or open edge.",
    "Crease, or change of material or texture.",
    "Intersection of surfaces.",
    "Edge of a shadow. Hard shadows may cut pixels that are not split otherwise.",
    "Edge of a reflected object.",
    "No edge, but the shading varies within the pixel.",
    "No edge found; split because samples differ, as at alpha edges.",
    "Too many edges: sampled instead.",
    "MAX reached with edges left.",
    "Out of focus: sampled over the lens.",
    "Moves while the shutter is open: the mean of many moments.",
};

void swatch(ImVec2 lo, ImVec2 hi, glm::u8vec3 colour) {
  ImGui::GetWindowDrawList()->AddRectFilled(lo, hi, theme::packed(colour));
}

/// One colour of the scale of levels.
struct LevelSwatch {
  std::string label;
  glm::u8vec3 colour;
  std::string tooltip;
  float width = 1.0f;  ///< in parts of the scale
};

std::vector<LevelSwatch> level_swatches() {
  std::vector<LevelSwatch> swatches{
      {"not split", split_colour(0), "Not split: one sample was enough.", 3.56f},
      {"exact", exact_colour,
       "Exact: level 0, but cut along an edge of a surface, shadow or reflection.", 2.52f},
      {"sampled", sampled_colour, "Sampled: not divided, but the mean of several samples.", 3.74f}};
  for (int level = 1; level <= split_colour_levels; ++level)
    swatches.push_back({std::to_string(level), split_colour(level),
                        fmt::format("Level {}: finest cells of 1/{} pixel.", level, 1 << level)});
  return swatches;
}

// The split map's colours by level. The scale is absolute: a level has the same colour at any MAX.
void level_legend(Controls& controls) {
  const std::vector<LevelSwatch> swatches = level_swatches();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float em = ImGui::GetFontSize();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.9f * em;
  float parts = 0.0f;
  for (const LevelSwatch& s : swatches) parts += s.width;
  float left = corner.x;
  for (const LevelSwatch& s : swatches) {
    const float right = left + s.width / parts * width;
    swatch({left, corner.y}, {right, corner.y + height}, s.colour);
    const float text = ImGui::CalcTextSize(s.label.c_str()).x;
    if (text <= right - left)
      draw->AddText({left + 0.5f * (right - left - text), corner.y + height + 0.15f * em},
                    theme::packed(theme::dim_text), s.label.c_str());
    ImGui::SetCursorScreenPos({left, corner.y});
    ImGui::Dummy({right - left, height});
    controls.placed("Level/" + s.label, s.tooltip.c_str());
    left = right;
  }
  draw->AddRect(corner, {corner.x + width, corner.y + height}, theme::packed(theme::line));
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height + 1.3f * em});
}

// The logarithmic scale of rays or time.
void cost_legend(Controls& controls, SplitMapColours colours) {
  std::vector<ScaleTick> ticks;
  for (const CostStep& step : cost_steps(colours))
    ticks.push_back({static_cast<float>(cost_scale(colours).share(step.value)), step.words});
  scale_strip(controls, "Scale",
              colours == SplitMapColours::rays
                  ? "Rays per pixel, 1 to 4096, logarithmic. The scale is absolute."
                  : "CPU time per pixel, 0.1 µs to 10 ms, logarithmic. The scale is absolute.",
              ticks, [key = SplitMapKey{colours}](float share) {
                return key.colour(static_cast<std::uint8_t>(1.0f + 254.0f * share));
              });
}

// One swatch per cause that occurs, in two columns.
void cause_legend(Controls& controls, const CauseCounts& causes) {
  const float em = ImGui::GetFontSize();
  const float column = 0.5f * ImGui::GetContentRegionAvail().x;
  bool right = false;
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    if (causes.pixels[i] == 0) continue;
    if (std::exchange(right, !right)) ImGui::SameLine(column + ImGui::GetStyle().WindowPadding.x);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    swatch(corner, {corner.x + 1.6f * em, corner.y + 0.9f * em},
           split_cause_colour(static_cast<SplitCause>(i)));
    ImGui::GetWindowDrawList()->AddText({corner.x + 2.0f * em, corner.y - 0.05f * em},
                                        theme::packed(theme::dim_text), split_cause_titles[i]);
    ImGui::Dummy({column - em, 1.1f * em});
    controls.placed(std::string("Cause/") + split_cause_titles[i], cause_words[i]);
  }
}

// A swatch with GlDisplay's hatching.
void unfinished_row(Controls& controls) {
  const float em = ImGui::GetFontSize();
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const ImVec2 hi{lo.x + 1.6f * em, lo.y + 0.9f * em};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(lo, hi, true);
  for (float x = lo.x; x < hi.x + em; x += 0.4f * em)
    draw->AddLine({x, lo.y}, {x - 0.9f * em, hi.y}, theme::packed(theme::dim_text));
  draw->PopClipRect();
  draw->AddText({lo.x + 2.0f * em, lo.y - 0.05f * em}, theme::packed(theme::dim_text),
                "predicted, or not final yet");
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, 1.1f * em});
  controls.placed("Unfinished", "Hatched pixels are predicted, or not final yet.");
}

}  // namespace

bool split_legend(Controls& controls, const DisplaySettings& display, const MapFacts& map,
                  const WindowRect& area, bool at_right) {
  if (!display.show_split_map || !display.show_legend) return false;
  const LegendWindow window(controls, "Map legend", area, legend_width_em, 8.0f, at_right);
  if (!window.has_room()) return false;
  std::string title = legend_title(display.split_colours);
  if (display.split_colours == SplitMapColours::level)
    title += fmt::format(" (MAX = {})", map.max_level);
  controls.text("Legend title", title);
  switch (display.split_colours) {
    case SplitMapColours::level:
      level_legend(controls);
      break;
    case SplitMapColours::cause:
      cause_legend(controls, map.causes);
      break;
    case SplitMapColours::rays:
    case SplitMapColours::time:
      cost_legend(controls, display.split_colours);
      break;
  }
  if (map.unfinished) unfinished_row(controls);
  const bool why =
      controls.button("Why is this pixel like this?",
                      "Inspect the most deeply split pixel. Click any pixel to inspect it.");
  ImGui::SameLine();
  ImGui::TextDisabled("M: hide   C: next");
  return why;
}

const char* words_of(SplitCause cause) {
  return cause_words[static_cast<std::size_t>(cause)];
}

}  // namespace asos::ui
