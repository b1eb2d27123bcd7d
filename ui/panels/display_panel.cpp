#include "ui/panels/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>

namespace asos {

namespace {

constexpr std::array colour_options{
    Controls::Option{"Level",
                     "Colour each split pixel by the deepest level that it was split to. Key: C."},
    Controls::Option{"Cause", "Colour each split pixel by why it was split. Key: C."},
    Controls::Option{"Rays", "Colour each pixel by how many rays of all kinds it took. Key: C."},
    Controls::Option{"Time",
                     "Colour each pixel by the time of one processor that it took; pixels that are "
                     "rendered together share theirs evenly. Key: C."},
};

constexpr std::array tone_options{
    Controls::Option{"None",
                     "What is brighter than white is white. EPS and contrasts are judged as the "
                     "curve shows them, so that another one renders anew."},
    Controls::Option{"Neutral",
                     "Khronos PBR Neutral: base colours come out as they are told, and what is "
                     "brighter is compressed without a change of hue."},
    Controls::Option{"AgX", "Like film: a soft contrast, and bright colours that fade to white."},
};
static_assert(tone_options.size() == tone_names.size());

}  // namespace

void display_panel(Controls& controls, DisplaySettings& display) {
  const DisplaySettings usual;
  if (!controls.section("Display")) return;
  controls.slider(
      "Exposure",
      "Brightness of the picture in stops: +1 doubles it. Changes what is shown, not "
      "what is rendered.",
      display.exposure_ev,
      {-DisplaySettings::exposure_limit_ev, DisplaySettings::exposure_limit_ev, usual.exposure_ev},
      [](float ev) { return fmt::format("{:+.2f} EV", ev); });
  int tone = static_cast<int>(display.tone);
  if (controls.options("Tone", tone_options, tone, {true, static_cast<int>(usual.tone)}))
    display.tone = static_cast<ToneCurve>(tone);
  controls.checkbox(
      "Grid",
      "A grid through the scene's lowest point, in steps of 1, 2 or 5 times a power "
      "of ten of the file's units, and the axes from its origin, X, Y and Z. Surfaces "
      "in front hide the grid and let the axes shine through. Saved pictures are "
      "without it.",
      display.show_grid, usual.show_grid);
  controls.checkbox("Split map", "Show in colours which pixels were split. Key: M.",
                    display.show_split_map, usual.show_split_map);
  if (!display.show_split_map) return;
  controls.slider("Dimming",
                  "How dark the pixels that are not split become under the split map, 0 to 100 %.",
                  display.split_dimming, {0.0f, 1.0f, usual.split_dimming},
                  [](float share) { return fmt::format("{:.0f} %", 100.0f * share); });
  controls.checkbox("Legend", "Say over the picture what the split map's colours mean.",
                    display.show_legend, usual.show_legend);
  int colours = static_cast<int>(display.split_colours);
  if (controls.options("Colours", colour_options, colours,
                       {true, static_cast<int>(usual.split_colours)}))
    display.split_colours = static_cast<SplitMapColours>(colours);
}

}  // namespace asos
