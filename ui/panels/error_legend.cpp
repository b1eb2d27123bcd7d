#include "ui/error_map.h"
#include "ui/panels/heat_strip.h"
#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/snapshot_table.h"
#include "ui/split_check.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr float error_legend_width_em = 24.0f;

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

}  // namespace

void error_legend(Controls& controls, const ErrorFacts& facts, const WindowRect& area) {
  const LegendWindow window(controls, "Error legend", area, error_legend_width_em);
  if (!window.has_room()) return;
  ImGui::TextUnformatted("Error per pixel");
  error_scale(controls);
  const std::string words = reference_words(facts);
  ImGui::TextDisabled("%s", words.c_str());
  controls.placed_words("Error reference", words, "It is kept while EPS, MAX and method change.");
  if (facts.summary) summary_row(controls, *facts.summary);
}

}  // namespace asos::ui
