#include "ui/panels/time_words.h"

#include "renderer/files/counted.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace asos::ui {

namespace {

std::string rough_duration(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.0f} s", std::max(1.0, std::ceil(seconds)));
  if (seconds <= 55.0) return fmt::format("{:.0f} s", 5.0 * std::ceil(seconds / 5.0));
  // Whole minutes would say 2 min for 61 s.
  constexpr double few_minutes = 300.0;
  if (seconds <= few_minutes) {
    const int whole = 10 * static_cast<int>(std::ceil(seconds / 10.0));
    return whole % 60 == 0 ? fmt::format("{} min", whole / 60)
                           : fmt::format("{} min {} s", whole / 60, whole % 60);
  }
  if (seconds < 3600.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

const char* doing(PauseReason rest) {
  switch (rest) {
    case PauseReason::none:
      break;
    case PauseReason::paused:
      return "Paused at";
    case PauseReason::time:
      return "Time limit reached,";
    case PauseReason::quality:
      return "Quality reached,";
    case PauseReason::stopped:
      return "Stopped at";
  }
  return "";
}

}  // namespace

std::string duration_words(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 60.0) return fmt::format("{:.0f} s", seconds);
  const int whole = static_cast<int>(seconds);
  if (seconds < 3600.0) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string wait_words(double seconds) {
  return fmt::format("{} left", rough_duration(seconds));
}

std::string processor_words(double seconds) {
  return fmt::format("{:.3g} s", seconds);
}

std::string pass_words(const Reached& reached) {
  if (reached.final_share >= 0.01)
    return fmt::format("{} % final", static_cast<int>(100.0 * reached.final_share));
  if (reached.pass == Reached::Pass::nothing) return "";
  if (reached.pass != Reached::Pass::samples) return "first samples";
  return counted(static_cast<std::uint64_t>(reached.samples), "sample") + " per pixel";
}

std::string progress_words(const ProgressFacts& facts) {
  const Progress& progress = facts.progress;
  if (progress.failed) return "Not enough memory for edges";
  if (progress.finished) return "Finished in " + duration_words(progress.seconds);
  // Small percentages have a decimal, so that slow renders visibly progress.
  const double percent = 100.0 * facts.fraction;
  const std::string share = fmt::format("{:.{}f} %", percent, percent < 9.95 ? 1 : 0);
  std::string text = facts.rest == PauseReason::none
                         ? share + " done   "
                         : fmt::format("{} {}   ", doing(facts.rest), share);
  const bool searching = facts.without_edges && facts.rest == PauseReason::none;
  const std::string pass = searching ? "finding edges" : pass_words(facts.reached);
  if (!pass.empty()) text += pass + "   ";
  text += duration_words(progress.seconds);
  if (const std::optional<double> left = seconds_left(facts)) text += "   " + wait_words(*left);
  return text;
}

std::optional<double> seconds_left(const ProgressFacts& facts) {
  const Progress& progress = facts.progress;
  if (progress.seconds_left < 0.0 || !(facts.fraction > 0.0)) return std::nullopt;
  return std::max(progress.seconds_left,
                  progress.seconds * (1.0 - facts.fraction) / facts.fraction);
}

std::string estimate_words(double split_share, const TimeEstimate& estimate) {
  const double percent = 100.0 * split_share;
  return fmt::format("about {:.{}f} % split, {}", percent, percent < 1.0 ? 1 : 0,
                     rough_duration(estimate.all));
}

}  // namespace asos::ui
