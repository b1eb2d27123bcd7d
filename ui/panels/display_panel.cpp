#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr std::array tone_options{
    Controls::Option{"None",
                     "Clip at white. Changing the curve restarts the render, since errors are "
                     "judged on screen."},
    Controls::Option{"Neutral",
                     "Khronos PBR Neutral: base colours stay, brighter values are compressed "
                     "without hue shift."},
    Controls::Option{"AgX", "Film-like: soft contrast, bright colours fade to white."},
};
static_assert(tone_options.size() == tone_names.size());

}  // namespace

std::vector<std::string> layer_titles() {
  std::vector<std::string> titles{"Picture"};
  for (const LayerRow& row : layer_table())
    if (row.value != Layer::beauty) titles.emplace_back(row.title);
  return titles;
}

void show_next_layer(DisplaySettings& display, int by) {
  const int shown = display.layer ? static_cast<int>(*display.layer) : 0;
  const int next = (shown + by + layer_count) % layer_count;
  display.layer = next > 0 ? std::optional(static_cast<Layer>(next)) : std::nullopt;
}

const char* layer_title(const DisplaySettings& display) {
  return display.layer ? row_of(*display.layer).title : "Picture";
}

void display_panel(Controls& controls, DisplaySettings& display, const BarParts& bar) {
  const DisplaySettings usual;
  if (!controls.section("Display")) return;
  if (!bar.exposure || controls.searches())
    controls.slider("Exposure",
                    "Display brightness in stops; +1 doubles it. Does not restart the render.",
                    display.exposure_ev,
                    {-DisplaySettings::exposure_limit_ev, DisplaySettings::exposure_limit_ev,
                     usual.exposure_ev},
                    [](float ev) { return fmt::format("{:+.2f} EV", ev); });
  if (controls.checkbox("Auto exposure",
                        "Set the exposure by the brightness of the scene. Moving the slider "
                        "turns it off.",
                        display.auto_exposure, usual.auto_exposure) &&
      !display.auto_exposure)
    display.exposure_ev = usual.exposure_ev;
  controls.options("Tone", tone_options, display.tone, usual.tone);
  controls.checkbox(
      "Grid", "Grid at the scene's lowest point, and axes from the origin. Not in saved pictures.",
      display.show_grid, usual.show_grid);
  controls.checkbox("Axes",
                    "Show axes in the picture's corner. Click one, or drag, to turn the view.",
                    display.show_axes, usual.show_axes);
  controls.checkbox(
      "Scale bar",
      "Show a length at the distance of the point that the camera orbits. Only for glTF "
      "files, whose unit is the metre.",
      display.show_scale, usual.show_scale);
  controls.checkbox("Legends", "Show the legends of maps, layers and comparisons.",
                    display.show_legend, usual.show_legend);
  if (!display.show_split_map) return;
  controls.slider("Dimming", "Darkening of unsplit pixels, 0 to 100 %.", display.split_dimming,
                  {0.0f, 1.0f, usual.split_dimming}, percent_words);
}

}  // namespace asos::ui
