#include "ui/panels/heat_strip.h"
#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/snapshot_table.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

constexpr float comparison_legend_width_em = 24.0f;

void difference_scale(Controls& controls, float stops) {
  const std::array ticks{HeatTick{0.0f, "0"}, HeatTick{0.5f, scale_words(stops - 1.0f)},
                         HeatTick{1.0f, scale_words(stops)}};
  heat_strip(ticks);
  controls.placed_words("Difference scale",
                        ticks[0].text + " " + ticks[1].text + " " + ticks[2].text,
                        "Difference of display values, 0 to 1, in the largest channel.");
}

}  // namespace

void comparison_legend(Controls& controls, const Frames& frames, const WindowRect& area) {
  if (!frames.cover_picture()) return;
  const StoredFrame* compared = frames.compared();
  const bool difference = frames.comparison == Comparison::difference;
  const LegendWindow window(controls, "Comparison legend", area, comparison_legend_width_em);
  if (!window.has_room()) return;
  const std::string words =
      (difference ? "Difference from: " : "Snapshot (X: picture): ") + frames.title(*compared);
  ImGui::TextWrapped("%s", words.c_str());
  controls.placed_words("Compared snapshot", words, compared->summary.c_str());
  if (difference) difference_scale(controls, frames.scale_stops);
}

}  // namespace asos::ui
