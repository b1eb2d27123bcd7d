#include "ui/error_map.h"
#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/scale_strip.h"
#include "ui/panels/snapshot_table.h"
#include "ui/split_check.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>

namespace asos::ui {

namespace {

constexpr float comparison_legend_width_em = 24.0f;

void difference_scale(Controls& controls, float stops) {
  const std::array ticks{ScaleTick{0.0f, "0"}, ScaleTick{0.5f, scale_words(stops - 1.0f)},
                         ScaleTick{1.0f, scale_words(stops)}};
  scale_strip(controls, "Difference scale",
              "Difference of display values, 0 to 1, in the largest channel.", ticks);
}

void error_scale(Controls& controls) {
  const std::array ticks{
      ScaleTick{ErrorScale::share(0.25), "1/4"}, ScaleTick{ErrorScale::share(1.0), "1 step"},
      ScaleTick{ErrorScale::share(4.0), "4"}, ScaleTick{ErrorScale::share(16.0), "16"},
      ScaleTick{ErrorScale::share(64.0), "64 steps"}};
  scale_strip(controls, "Error scale",
              "Error per pixel in 8-bit display steps, logarithmic. Black: less than 1/4.", ticks);
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
  controls.text("Error summary", words,
                "Whole picture against the reference: clipped linear values, and the percentage of "
                "pixels with a visible error.");
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
  controls.dim_text("Error reference", reference_words(facts),
                    "It is kept while EPS, MAX and method change.");
  if (facts.summary) summary_row(controls, *facts.summary);
}

}  // namespace asos::ui
