#include "ui/error_map.h"
#include "ui/panels/heat_strip.h"
#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/snapshot_table.h"
#include "ui/split_check.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

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

struct ErrorTick {
  double steps;
  const char* text;
};
constexpr std::array error_ticks{ErrorTick{0.25, "1/4"}, ErrorTick{1.0, "1 step"},
                                 ErrorTick{4.0, "4"}, ErrorTick{16.0, "16"},
                                 ErrorTick{64.0, "64 steps"}};

void error_scale(Controls& controls) {
  std::vector<HeatTick> ticks;
  std::string words;
  for (const ErrorTick& tick : error_ticks) {
    words += (words.empty() ? "" : " ") + std::string(tick.text);
    ticks.push_back({ErrorScale::share(tick.steps), tick.text});
  }
  heat_strip(ticks);
  controls.placed_words(
      "Error scale", words,
      "Error per pixel in 8-bit display steps, logarithmic. Black: less than 1/4.");
}

std::string reference_words(const ErrorFacts& facts) {
  constexpr int whole = SplitCheck::most_passes * SplitCheck::samples_each;
  if (facts.samples >= whole) return fmt::format("Reference: {} samples per pixel", whole);
  if (facts.samples > 0) return fmt::format("Reference: {} of {} samples", facts.samples, whole);
  return facts.finished ? "Sampling the reference" : "Waiting for the finished picture";
}

void summary_row(Controls& controls, const ErrorSummary& summary) {
  const std::string words = fmt::format("RMSE {:.2g} ({}), above 1 step: {:.2g} %", summary.rmse,
                                        psnr_words(summary.rmse), 100.0 * summary.visible);
  ImGui::TextUnformatted(words.c_str());
  controls.placed_words("Error summary", words,
                        "Whole picture against the reference: clipped linear values, and the "
                        "percentage of pixels with a visible error.");
}

// What covers the picture, by name.
std::string legend_words(const Frames& frames) {
  if (frames.comparison == Comparison::flip) return frames.compared_title() + " (X: picture)";
  if (frames.comparison == Comparison::difference)
    return "Difference from: " + frames.compared_title();
  if (frames.with == CompareWith::reference) return "Error per pixel";
  return frames.compared() ? "Error against: " + frames.compared_title() : "No snapshot yet";
}

}  // namespace

void comparison_legend(Controls& controls, const Frames& frames, const ErrorFacts& facts,
                       const WindowRect& area) {
  const LegendWindow window(controls, "Comparison legend", area, comparison_legend_width_em);
  if (!window.has_room()) return;
  const std::string title = legend_words(frames);
  ImGui::TextWrapped("%s", title.c_str());
  controls.placed_words("Compared", title, nullptr);
  if (frames.comparison == Comparison::difference) difference_scale(controls, frames.scale_stops);
  if (frames.comparison != Comparison::error) return;
  error_scale(controls);
  if (frames.with != CompareWith::reference) return;
  const std::string words = reference_words(facts);
  ImGui::TextDisabled("%s", words.c_str());
  controls.placed_words("Error reference", words, "It is kept while EPS, MAX and method change.");
  if (facts.summary) summary_row(controls, *facts.summary);
}

}  // namespace asos::ui
